// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOpticsVolumeMapper
 * @brief VTK's GPU ray caster with the optical models of vtkOpticsVolumeProperty.
 */

#ifndef vtkOpticsVolumeMapper_h
#define vtkOpticsVolumeMapper_h

#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class vtkOpticsVolumeProperty;

class VTKVOLUMEOPTICS_EXPORT vtkOpticsVolumeMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkOpticsVolumeMapper* New();
  vtkTypeMacro(vtkOpticsVolumeMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether vtkGPUVolumeRayCastMapper::New(), also inside vtkSmartVolumeMapper, gives this mapper.
   * Default off.
   */
  static void SetGlobalOverride(bool enabled);
  static bool GetGlobalOverride();
  ///@}

  ///@{
  /**
   * The optics of volumes whose property is a plain vtkVolumeProperty and whose mapper was given
   * none. Default null: VTK's own model.
   */
  static void SetDefaultOptics(vtkOpticsVolumeProperty* property);
  static vtkOpticsVolumeProperty* GetDefaultOptics();
  ///@}

protected:
  vtkOpticsVolumeMapper() = default;
  ~vtkOpticsVolumeMapper() override = default;

private:
  vtkOpticsVolumeMapper(const vtkOpticsVolumeMapper&) = delete;
  void operator=(const vtkOpticsVolumeMapper&) = delete;
};

#endif
