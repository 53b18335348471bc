// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Algorithm 1 of [Ament2015] as it is written: random points for every voxel. The baseline that the
// row patterns are compared with.

#ifndef LiteralSampling_h
#define LiteralSampling_h

#include "CovarianceKernel.h"
#include "SamplePattern.h"
#include "VoxelBox.h"

namespace volumeoptics
{
struct CovarianceSettings;

class LiteralSampling
{
public:
  LiteralSampling(const Ball& ball, const VoxelBox<float>& scalars, const CovarianceSettings& settings);

  // The sums of the row's voxel number `voxel`, which lies at x, y, z.
  void Accumulate(CovarianceRow& row, int voxel, int x, int y, int z) const;

private:
  struct Found
  {
    float Scalar;     // NaN for no value
    glm::vec3 Offset; // in voxels
  };
  Found Sample(const glm::vec3& voxels, int x, int y, int z) const;
  float Interpolated(const glm::ivec3& corner, const glm::vec3& fraction) const;

  const VoxelBox<float>& Scalars;
  const CovarianceSettings& Settings;
  glm::vec3 VoxelsPerRadius;
  glm::mat3 WorldOfVoxels; // world offset in radii of an index offset
};
}

#endif
