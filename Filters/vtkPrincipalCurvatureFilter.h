// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkPrincipalCurvatureFilter
 * @brief Anisotropy of the isosurface's curvature at each voxel.
 *
 * The other source of tangent frames that [Ament2015] Fig. 5 compares with: highlights run along
 * the direction of the smaller absolute principal curvature, k2. The strength is
 * (|k1| - |k2|)/(|k1| + |k2|): 1 on a cylinder, 0 on a sphere, a plane and a symmetric saddle.
 * Curvatures are those of the geometry tensor of [Kindlmann2003], from Sobel gradients and central
 * second differences. Local and fast, but noise grows with the second derivative: Smoothing is 1
 * voxel by default. Decode with normals of the same Smoothing.
 *
 * Output: see vtkAnisotropyFilter, in the array `AmbientCovariance`, so that everything that draws
 * covariance draws curvature. A voxel without a gradient has no estimate.
 *
 * @sa vtkAmbientCovarianceFilter
 */

#ifndef vtkPrincipalCurvatureFilter_h
#define vtkPrincipalCurvatureFilter_h

#include "vtkAnisotropyFilter.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class VTKVOLUMEOPTICS_EXPORT vtkPrincipalCurvatureFilter : public vtkAnisotropyFilter
{
public:
  static vtkPrincipalCurvatureFilter* New();
  vtkTypeMacro(vtkPrincipalCurvatureFilter, vtkAnisotropyFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkPrincipalCurvatureFilter();
  ~vtkPrincipalCurvatureFilter() override = default;

  void GetReach(const volumeoptics::ImageGrid& grid, int reach[3]) override;
  bool ComputeCodes(const volumeoptics::ImageGrid& grid, const volumeoptics::ImageRows& rows,
    vtkInformationVector** inputs, volumeoptics::Batches& batches,
    volumeoptics::VoxelBox<float>& codes) override;

private:
  vtkPrincipalCurvatureFilter(const vtkPrincipalCurvatureFilter&) = delete;
  void operator=(const vtkPrincipalCurvatureFilter&) = delete;
};

#endif
