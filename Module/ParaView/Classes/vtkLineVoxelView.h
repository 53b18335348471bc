// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLineVoxelView
 * @brief vtkAnisotropicVoxelEvaluator with a camera that is given by numbers, and scales for all line types.
 */

#ifndef vtkLineVoxelView_h
#define vtkLineVoxelView_h

#include "vtkAnisotropicVoxelEvaluator.h"
#include "vtkVolumeOpticsParaViewModule.h" // for export macro

class VTKVOLUMEOPTICSPARAVIEW_EXPORT vtkLineVoxelView : public vtkAnisotropicVoxelEvaluator
{
public:
  static vtkLineVoxelView* New();
  vtkTypeMacro(vtkLineVoxelView, vtkAnisotropicVoxelEvaluator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The eye and what it looks at, in the coordinates of the voxels; in a parallel view their difference
   * alone counts. Default (0, 0, 1), (0, 0, 0), perspective.
   */
  void SetCameraPosition(double x, double y, double z);
  void SetCameraFocalPoint(double x, double y, double z);
  void SetParallelProjection(bool parallel);
  ///@}

  ///@{
  /**
   * SetRadiusScale() and SetOpacityScale() of the line types of all numbers.
   */
  void SetRadiusScaleOfAll(double scale);
  void SetOpacityScaleOfAll(double scale);
  ///@}

protected:
  vtkLineVoxelView();
  ~vtkLineVoxelView() override = default;

private:
  vtkLineVoxelView(const vtkLineVoxelView&) = delete;
  void operator=(const vtkLineVoxelView&) = delete;
};

#endif
