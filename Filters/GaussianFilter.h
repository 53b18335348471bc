// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A Gaussian that is round in world space, over the values that are there.

#ifndef GaussianFilter_h
#define GaussianFilter_h

#include "VoxelBox.h"

namespace volumeoptics
{
class GaussianFilter
{
public:
  // standardDeviation: world length. The Gaussian ends at three of them.
  GaussianFilter(const ImageGrid& grid, double standardDeviation);

  const Halo& GetHalo() const { return this->Reach; }

  // Means of `values` over `box`; a voxel whose first number is NaN takes no part, and stays NaN
  // where keepMissing is set. Rows of the result are padded by one NaN at each end.
  VoxelBox<double> Apply(const VoxelBox<double>& values, const Extent& box, bool keepMissing = true) const;

private:
  VoxelBox<double> ApplyAlong(int axis, const VoxelBox<double>& weighted, const Extent& box) const;

  Halo Reach;
  std::vector<double> Weights[3]; // from the centre outwards
};
}

#endif
