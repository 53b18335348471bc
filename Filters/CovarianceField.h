// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// From scalars and normals to the codes of vtkAmbientCovarianceFilter.

#ifndef CovarianceField_h
#define CovarianceField_h

#include "AnisotropyCode.h"
#include "CovarianceSampler.h"
#include "NormalSource.h"

#include <memory>

namespace volumeoptics
{
class Batches;

struct CovarianceFieldSettings
{
  CovarianceSettings Sampling;
  double ScalarRange[2];
  double FilterStandardDeviation; // world length, 0 for none
  bool NoiseCorrection;
  Storage Code;
};

class CovarianceField
{
public:
  // normals: null for those of the scalars.
  CovarianceField(const ImageGrid& grid, const ScalarSource& scalars, const NormalSource* normals,
    const CovarianceFieldSettings& settings);

  // False if aborted.
  bool Compute(Batches& batches, VoxelBox<float>& codes);

  // Voxels around one whose scalars its code needs.
  static Halo GetReach(const ImageGrid& grid, double radius, double filterStandardDeviation);
  // ... whose normals it needs.
  static Halo GetFilterReach(const ImageGrid& grid, double filterStandardDeviation);

private:
  bool LoadScalars(Batches& batches, const Extent& box);
  void SetNormals(
    const Extent& tile, std::vector<CovarianceRows>& rows, std::vector<glm::dvec3>& normals) const;
  void StoreCode(
    const glm::dvec3& normal, const glm::dvec3& tangentCovariance, double accepted, float* code) const;
  void StoreCodes(const glm::dvec3* normals, const CovarianceRows& row, int y, int z, VoxelBox<float>& codes);
  void StoreTensors(const glm::dvec3* normals, const CovarianceRows& row, int y, int z, VoxelBox<float>&);
  bool Filter(Batches& batches, VoxelBox<float>& codes);
  void FilterTile(const Extent& tile, VoxelBox<float>& codes) const;

  const ImageGrid& Grid;
  const ScalarSource& Source;
  const NormalSource* Normals;
  const CovarianceFieldSettings& Settings;
  CovarianceSampler Sampler;
  VoxelBox<float> Scalars; // as fractions of the range
  VoxelBox<float> Tensors; // xx yy zz xy xz yz in world axes, accepted; only to be filtered
  VoxelBox<float> FilterNormals;
};
}

#endif
