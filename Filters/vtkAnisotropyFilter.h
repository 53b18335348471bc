// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkAnisotropyFilter
 * @brief Superclass of the filters whose output is the anisotropy of each voxel's surroundings.
 *
 * Adds the point array `AmbientCovariance`: direction and strength of an anisotropy in the plane
 * across the voxel's normal, with respect to the normals of vtkSobelNormalFilter of the same
 * Smoothing and ResolutionFactor (decode with those; Module/Optics/AnisotropyFrame.glsl). A voxel
 * without an estimate has the mean of the numbers of those of its 26 neighbours that have one, 0 if
 * none has.
 *
 * @sa vtkAmbientCovarianceFilter vtkPrincipalCurvatureFilter
 */

#ifndef vtkAnisotropyFilter_h
#define vtkAnisotropyFilter_h

#include "vtkOpticsImageFilter.h"
#include "vtkVolumeOpticsModule.h" // for export macro

namespace volumeoptics
{
template <typename Number>
class VoxelBox;
}

class VTKVOLUMEOPTICS_EXPORT vtkAnisotropyFilter : public vtkOpticsImageFilter
{
public:
  vtkTypeMacro(vtkAnisotropyFilter, vtkOpticsImageFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What the numbers are. Map: 3 numbers in [-1, 1] that stay right under interpolation for any
   * normal. Components: the 3 of [Ament2015] eq. 24, normalised, which fail near normals along z;
   * for comparison; their names are C11, C12 and C22. World: 5 numbers in [-1, 1], xx yy xy xz yz of the traceless tensor, free of
   * the normal's sign. Default Map.
   */
  enum StorageType
  {
    Map = 0,
    Components,
    World
  };
  void SetStorage(int storage);
  void SetStorageToMap() { this->SetStorage(Map); }
  void SetStorageToComponents() { this->SetStorage(Components); }
  void SetStorageToWorld() { this->SetStorage(World); }
  vtkGetMacro(Storage, int);
  const char* GetStorageAsString();
  ///@}

protected:
  vtkAnisotropyFilter() = default;
  ~vtkAnisotropyFilter() override = default;

  /**
   * Sets the numbers of all voxels of a box, NaN where there is no estimate. The box is the
   * output's, grown by one voxel. False on abort or error.
   */
  virtual bool ComputeCodes(const volumeoptics::ImageGrid& grid, const volumeoptics::ImageRows& rows,
    vtkInformationVector** inputs, volumeoptics::Batches& batches, volumeoptics::VoxelBox<float>& codes) = 0;

  bool ComputeArrays(const volumeoptics::ImageGrid& grid, const volumeoptics::ImageRows& rows,
    vtkInformationVector** inputs, volumeoptics::Batches& batches, vtkImageData* output) override;

  int Storage = Map;

private:
  vtkAnisotropyFilter(const vtkAnisotropyFilter&) = delete;
  void operator=(const vtkAnisotropyFilter&) = delete;
};

#endif
