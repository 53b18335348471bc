// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour and opacity of anisotropic voxels in a view direction.

#ifndef VoxelEvaluation_h
#define VoxelEvaluation_h

#include "LineVoxels.h"

#include <vector>

namespace volumeoptics
{
struct LineScale
{
  double Radius = 1.0;
  double Opacity = 1.0;
};

// Of one line type in one voxel.
struct EvaluatedVoxel
{
  glm::dvec3 Color = glm::dvec3(0.0);
  double Depth = 0.0; // 1 - exp(-Depth) is the opacity
};

// basis: all harmonics up to the order in the direction, by l (l + 1) + m. voxel: its number in the set.
EvaluatedVoxel EvaluateVoxel(
  const LineCoefficients& set, vtkTypeInt64 voxel, const double* basis, const LineScale& scale);
}

#endif
