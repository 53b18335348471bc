// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VoxelEvaluation.h"

#include "CylinderProjection.h"
#include "Optics.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
// Truncated sums below this share of the mean hold more truncation than light.
const double LeastShare = 0.02;

// The part of degree 0 comes first: it is never dropped.
struct Sums
{
  double Channels[LineChannels] = {};
  double Degree0 = 0.0, Degree2 = 0.0; // of the depth
};

Sums SumVoxel(const LineCoefficients& set, vtkTypeInt64 voxel, const double* basis)
{
  Sums sums;
  for (vtkTypeInt64 i = set.VoxelStarts[voxel]; i < set.VoxelStarts[voxel + 1]; ++i)
  {
    const int harmonic = set.Harmonics[i];
    const float* values = set.Values + i * set.Channels;
    for (int c = 0; c < LineChannels; ++c)
    {
      sums.Channels[c] += values[c] * basis[harmonic];
    }
    const double depth = values[AreaChannel] * basis[harmonic];
    sums.Degree0 += harmonic == 0 ? depth : 0.0;
    sums.Degree2 += harmonic >= 4 && harmonic < 9 ? depth : 0.0;
  }
  return sums;
}

// The ratio of the sums as they are; where they are small, that of the means over all directions.
glm::dvec3 ColorOf(const LineCoefficients& set, vtkTypeInt64 voxel, const Sums& sums)
{
  const double area = sums.Channels[AreaChannel];
  glm::dvec3 color = glm::dvec3(sums.Channels[0], sums.Channels[1], sums.Channels[2]) / area;
  if (!(area > LeastShare * sums.Degree0))
  {
    const float* mean = set.Values + set.VoxelStarts[voxel] * set.Channels;
    color = glm::dvec3(mean[0], mean[1], mean[2]) / static_cast<double>(mean[AreaChannel]);
  }
  return glm::clamp(color, set.LeastColor, set.LargestColor);
}
}

EvaluatedVoxel EvaluateVoxel(
  const LineCoefficients& set, vtkTypeInt64 voxel, const double* basis, const LineScale& scale)
{
  const Sums sums = SumVoxel(set, voxel, basis);
  EvaluatedVoxel result;
  if (!(sums.Degree0 > 0.0) || scale.Radius * scale.Opacity <= 0.0)
  {
    return result;
  }
  const double area = sums.Channels[AreaChannel];
  const glm::dvec2 bounds = optics::DepthBounds(sums.Degree0, sums.Degree2);
  result.Depth = std::clamp(area, bounds.x, bounds.y) * scale.Radius;
  if (scale.Opacity < 1.0)
  {
    result.Depth = optics::OpticalDepth(scale.Opacity * optics::OneMinusExp(result.Depth));
  }
  result.Color = ColorOf(set, voxel, sums);
  return result;
}
}
