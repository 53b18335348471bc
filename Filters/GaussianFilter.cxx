// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GaussianFilter.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
const double CutOff = 3.0;

// The numbers of each voxel and a weight of 1 after them; all 0 where there is no value.
VoxelBox<double> WithWeights(const VoxelBox<double>& values)
{
  const Extent& box = values.GetBox();
  const int components = values.GetComponents();
  VoxelBox<double> weighted(box, components + 1, 0, 0.0);
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      const double* from = values.Row(y, z);
      double* to = weighted.Row(y, z);
      for (int x = box[0]; x <= box[1]; ++x, from += components, to += components + 1)
      {
        if (!std::isnan(from[0]))
        {
          std::copy(from, from + components, to);
          to[components] = 1.0;
        }
      }
    }
  }
  return weighted;
}
}

GaussianFilter::GaussianFilter(const ImageGrid& grid, double standardDeviation)
  : Reach(CoveringHalo(grid, CutOff * standardDeviation))
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i <= this->Reach[axis]; ++i)
    {
      const double deviations = i * std::abs(grid.Spacing[axis]) / standardDeviation;
      this->Weights[axis].push_back(i > 0 ? std::exp(-0.5 * deviations * deviations) : 1.0);
    }
  }
}

VoxelBox<double> GaussianFilter::ApplyAlong(
  int axis, const VoxelBox<double>& weighted, const Extent& box) const
{
  const Extent& source = weighted.GetBox();
  const int components = weighted.GetComponents();
  const std::size_t length = static_cast<std::size_t>(box[1] - box[0] + 1) * components;
  VoxelBox<double> means(box, components, 0, 0.0);
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      double* to = means.Row(y, z);
      for (int shift = -this->Reach[axis]; shift <= this->Reach[axis]; ++shift)
      {
        const int dx = axis == 0 ? shift : 0;
        const int fromY = axis == 1 ? y + shift : y;
        const int fromZ = axis == 2 ? z + shift : z;
        if (!weighted.HasRow(fromY, fromZ))
        {
          continue;
        }
        const int x0 = std::max(box[0], source[0] - dx);
        const int x1 = std::min(box[1], source[1] - dx);
        const double weight = this->Weights[axis][std::abs(shift)];
        const double* from = weighted.At(x0 + dx, fromY, fromZ);
        const std::size_t start = static_cast<std::size_t>(x0 - box[0]) * components;
        const std::size_t end =
          std::min(length, static_cast<std::size_t>(std::max(x1 - box[0] + 1, 0)) * components);
        for (std::size_t i = start; i < end; ++i)
        {
          to[i] += weight * from[i - start];
        }
      }
    }
  }
  return means;
}

VoxelBox<double> GaussianFilter::Apply(
  const VoxelBox<double>& values, const Extent& box, bool keepMissing) const
{
  const Extent& source = values.GetBox();
  const Extent alongX = { box[0], box[1], source[2], source[3], source[4], source[5] };
  const Extent alongY = { box[0], box[1], box[2], box[3], source[4], source[5] };
  VoxelBox<double> sums = this->ApplyAlong(0, WithWeights(values), alongX);
  sums = this->ApplyAlong(1, sums, alongY);
  sums = this->ApplyAlong(2, sums, box);
  const int components = values.GetComponents();
  VoxelBox<double> means(box, components, components, NoValue<double>());
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      for (int x = box[0]; x <= box[1]; ++x)
      {
        const double* sum = sums.At(x, y, z);
        const double weight = sum[components];
        if (weight > 0.0 && !(keepMissing && std::isnan(*values.At(x, y, z))))
        {
          double* mean = means.At(x, y, z);
          std::transform(sum, sum + components, mean, [weight](double s) { return s / weight; });
        }
      }
    }
  }
  return means;
}
}
