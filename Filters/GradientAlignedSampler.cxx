// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GradientAlignedSampler.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
glm::dmat3 StepMatrix(const ImageGrid& grid, double step)
{
  // GradientToWorld is the inverse transpose of the direction.
  glm::dmat3 matrix = glm::transpose(grid.GradientToWorld);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[column][axis] *= step / grid.Spacing[axis];
    }
  }
  return matrix;
}
}

Halo GradientAlignedSampler::GetReach(const ImageGrid& grid, double step)
{
  const glm::dmat3 matrix = glm::transpose(StepMatrix(grid, step));
  Halo reach;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int largest = grid.Whole[2 * axis + 1] - grid.Whole[2 * axis];
    const double voxels = std::min(std::ceil(glm::length(matrix[axis])), std::max(largest, 1) * 1.0);
    reach[axis] = std::max(static_cast<int>(voxels), 1); // 1: the gradient's
  }
  return reach;
}

GradientAlignedSampler::GradientAlignedSampler(
  const ImageGrid& grid, const ScalarSource& source, const Extent& tile, double step)
  : Tile(tile)
  , StepToIndex(StepMatrix(grid, step))
  , Stencil(grid)
  , Scalars(source.Load(Grown(tile, GetReach(grid, step), grid.Whole)))
  , Gradients(tile[1] - tile[0] + 1)
  , Samples(Gradients.size())
{
}

// A weight of 0 must not let a missing value in.
double GradientAlignedSampler::InterpolateIncomplete(const int (&voxel)[3], const double (&weight)[3]) const
{
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double share = 1.0;
    int at[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isNext = (corner >> axis & 1) != 0;
      share *= isNext ? weight[axis] : 1.0 - weight[axis];
      at[axis] = std::min(voxel[axis] + isNext, this->Scalars.GetBox()[2 * axis + 1]);
    }
    value += share > 0.0 ? share * *this->Scalars.At(at[0], at[1], at[2]) : 0.0;
  }
  return value;
}

// Trilinear; outside the volume the border's value, as a texture's that is clamped to its edge.
double GradientAlignedSampler::Interpolate(const glm::dvec3& index) const
{
  const Extent& box = this->Scalars.GetBox();
  int voxel[3];
  double weight[3];
  bool isInside = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double inside =
      std::clamp(index[axis], static_cast<double>(box[2 * axis]), static_cast<double>(box[2 * axis + 1]));
    // extents may be negative: truncation from the box's corner is a floor
    voxel[axis] = box[2 * axis] + static_cast<int>(inside - box[2 * axis]);
    weight[axis] = inside - voxel[axis];
    isInside = isInside && voxel[axis] < box[2 * axis + 1];
  }
  double value = NoValue<double>();
  if (isInside)
  {
    const double* first = this->Scalars.At(voxel[0], voxel[1], voxel[2]);
    const std::ptrdiff_t y = this->Scalars.Offset(0, 1, 0);
    const std::ptrdiff_t z = this->Scalars.Offset(0, 0, 1);
    const auto along = [&](std::ptrdiff_t at) { return first[at] + weight[0] * (first[at + 1] - first[at]); };
    const double front = along(0) + weight[1] * (along(y) - along(0));
    const double back = along(z) + weight[1] * (along(y + z) - along(z));
    value = front + weight[2] * (back - front);
  }
  return std::isfinite(value) ? value : this->InterpolateIncomplete(voxel, weight);
}

const std::vector<GradientAlignedSample>& GradientAlignedSampler::Row(int y, int z)
{
  this->Stencil.Row(this->Scalars, this->Tile[0], this->Tile[1], y, z, this->Gradients.data());
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const int x = this->Tile[0] + static_cast<int>(i);
    GradientAlignedSample& sample = this->Samples[i];
    sample.Center = *this->Scalars.At(x, y, z);
    const NormalAndMagnitude surface = NormalOf(this->Gradients[i]);
    sample.GradientMagnitude = surface.Magnitude;
    if (!(surface.Magnitude > 0.0))
    {
      sample.Ahead = sample.Behind = sample.Center;
      continue;
    }
    const glm::dvec3 center(x, y, z);
    const glm::dvec3 downhill = this->StepToIndex * surface.Normal;
    sample.Ahead = this->Interpolate(center - downhill);
    sample.Behind = this->Interpolate(center + downhill);
  }
  return this->Samples;
}
}
