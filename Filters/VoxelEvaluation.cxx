// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VoxelEvaluation.h"

#include "Optics.h"

namespace volumeoptics
{
namespace
{
// The part of degree 0 comes first: it is never dropped.
struct Sums
{
  double Channels[LineChannels] = {};
  glm::dvec4 Degree0 = glm::dvec4(0.0);
  double Degree2 = 0.0; // of the depth
};

Sums SumVoxel(const LineCoefficients& set, vtkTypeInt64 voxel, const double* basis)
{
  Sums sums;
  for (vtkTypeInt64 i = set.VoxelStarts[voxel]; i < set.VoxelStarts[voxel + 1]; ++i)
  {
    const int harmonic = set.Harmonics[i];
    const float* values = set.Values + i * LineChannels;
    for (int c = 0; c < LineChannels; ++c)
    {
      sums.Channels[c] += values[c] * basis[harmonic];
    }
    if (harmonic == 0)
    {
      sums.Degree0 = basis[0] * glm::dvec4(values[0], values[1], values[2], values[AreaChannel]);
    }
    sums.Degree2 += harmonic >= 4 && harmonic < 9 ? values[AreaChannel] * basis[harmonic] : 0.0;
  }
  return sums;
}
}

EvaluatedVoxel EvaluateVoxel(
  const LineCoefficients& set, vtkTypeInt64 voxel, const double* basis, const LineScale& scale)
{
  const Sums sums = SumVoxel(set, voxel, basis);
  EvaluatedVoxel result;
  if (!(sums.Degree0.w > 0.0) || scale.Radius * scale.Opacity <= 0.0)
  {
    return result;
  }
  const double depth = sums.Channels[AreaChannel];
  result.Depth = optics::DepthOfLines(depth, sums.Degree0.w, sums.Degree2, scale.Radius, scale.Opacity);
  const glm::dvec3 light(sums.Channels[0], sums.Channels[1], sums.Channels[2]);
  result.Color = optics::ColorOfLines(
    light, depth, glm::dvec3(sums.Degree0), sums.Degree0.w, set.LeastColor, set.LargestColor);
  return result;
}
}
