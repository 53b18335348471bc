// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOpticsPreset
 * @brief Reads a vtkOpticsVolumeProperty's settings from a JSON file.
 *
 * The file is one object whose keys are the settings' names, all optional:
 * @code{.json}
 * { "ReflectanceModel": "Ward", "Glossiness": 0.2, "AnisotropyScale": 10, "ScatteringAnisotropy": 0,
 *   "SpecularFromExtinction": true, "FrameSource": "Covariance",
 *   "IntegrationSpace": "Data", "Classification": "PreIntegrated", "ScalarOpacityUnitInterval": 10,
 *   "Isosurfaces": [{ "Value": 300, "Opacity": 0.4, "Color": [0.9, 0.8, 0.7] }, { "Value": -300, "Opacity": 0.1 }],
 *   "Silhouette": "Exact", "TransmittedLight": "Diffuse",
 *   "Occlusion": true, "OcclusionAngle": 60, "AmbientColor": [1, 1, 1], "Shadows": true, "ShadowAngle": 5 }
 * @endcode
 * Glossiness and AnisotropyScale are those of the file's reflectance model, wherever in the file it
 * stands. Isosurfaces take the place of those that the property has; one without a colour has that of the
 * colour function. Comments are allowed. A key or value that is not understood is left out with a warning
 * that names the valid ones; a number outside its range becomes the nearest one of the range, as
 * vtkOpticsVolumeProperty does it.
 */

#ifndef vtkOpticsPreset_h
#define vtkOpticsPreset_h

#include "vtkObject.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class vtkOpticsVolumeProperty;

class VTKVOLUMEOPTICS_EXPORT vtkOpticsPreset : public vtkObject
{
public:
  static vtkOpticsPreset* New();
  vtkTypeMacro(vtkOpticsPreset, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Sets what the file names and leaves all other settings of the property as they are. Returns
   * false, after a warning, if the file cannot be read or is not a JSON object.
   */
  static bool Read(const char* fileName, vtkOpticsVolumeProperty* property);

protected:
  vtkOpticsPreset() = default;
  ~vtkOpticsPreset() override = default;

private:
  vtkOpticsPreset(const vtkOpticsPreset&) = delete;
  void operator=(const vtkOpticsPreset&) = delete;
};

#endif
