// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkSobelNormalFilter
 * @brief Unit normals of an image's scalar by a 3 x 3 x 3 Sobel operator.
 *
 * Adds the point arrays `Normals` (3 components, n = -grad s/|grad s| in world axes, 0 where the
 * gradient is 0; [Ament2015] section 4.1) and `GradientMagnitude` (per world length).
 *
 * What vtkImageSobel3D does not do: world axes by spacing and direction matrix, smoothing that is
 * equal along all axes where the spacing is not, borders by one-sided differences instead of
 * repeated voxels, missing values left out, double arithmetic for any scalar type.
 *
 * OutputPrecision rounds the normals alone.
 *
 * @sa vtkAmbientCovarianceFilter
 */

#ifndef vtkSobelNormalFilter_h
#define vtkSobelNormalFilter_h

#include "vtkOpticsImageFilter.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class VTKVOLUMEOPTICS_EXPORT vtkSobelNormalFilter : public vtkOpticsImageFilter
{
public:
  static vtkSobelNormalFilter* New();
  vtkTypeMacro(vtkSobelNormalFilter, vtkOpticsImageFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSobelNormalFilter() = default;
  ~vtkSobelNormalFilter() override = default;

  void GetReach(const volumeoptics::ImageGrid& grid, int reach[3]) override;
  bool ComputeArrays(const volumeoptics::ImageGrid& grid, const volumeoptics::ImageRows& rows,
    vtkInformationVector** inputs, volumeoptics::Batches& batches, vtkImageData* output) override;

private:
  vtkSobelNormalFilter(const vtkSobelNormalFilter&) = delete;
  void operator=(const vtkSobelNormalFilter&) = delete;
};

#endif
