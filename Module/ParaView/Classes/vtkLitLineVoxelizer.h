// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLitLineVoxelizer
 * @brief vtkAnisotropicLineVoxelizer with one material, given by numbers, for the lines of all types.
 */

#ifndef vtkLitLineVoxelizer_h
#define vtkLitLineVoxelizer_h

#include "vtkAnisotropicLineVoxelizer.h"
#include "vtkNew.h"                        // for the material
#include "vtkVolumeOpticsParaViewModule.h" // for export macro

class vtkProperty;

class VTKVOLUMEOPTICSPARAVIEW_EXPORT vtkLitLineVoxelizer : public vtkAnisotropicLineVoxelizer
{
public:
  static vtkLitLineVoxelizer* New();
  vtkTypeMacro(vtkLitLineVoxelizer, vtkAnisotropicLineVoxelizer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Coefficients in [0, 1], the highlight's exponent, at least 1, and the colour of ambient and diffuse
   * light. Default 0, 1, 0, 1, white.
   */
  void SetAmbient(double ambient);
  void SetDiffuse(double diffuse);
  void SetSpecular(double specular);
  void SetHighlightExponent(double exponent);
  void SetColor(double red, double green, double blue);
  ///@}

  /**
   * The way that light travels, in the coordinates of the lines, of any length: one white light, fixed in the world. Default
   * (0, 0, 0): a headlight.
   */
  void SetLightDirection(double x, double y, double z);

  ///@{
  /**
   * As SetRadiusArray() and the others; "None" is none.
   */
  void SelectRadiusArray(const char* name);
  void SelectLineTypeArray(const char* name);
  void SelectColorArray(const char* name);
  ///@}

protected:
  vtkLitLineVoxelizer();
  ~vtkLitLineVoxelizer() override;

private:
  vtkLitLineVoxelizer(const vtkLitLineVoxelizer&) = delete;
  void operator=(const vtkLitLineVoxelizer&) = delete;

  vtkNew<vtkProperty> Material;
};

#endif
