// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Gradient of a scalar by a 3 x 3 x 3 Sobel operator that honours spacing and missing values.

#ifndef SobelStencil_h
#define SobelStencil_h

#include "VoxelBox.h"

#include <glm/glm.hpp>

namespace volumeoptics
{
// The derivative along an axis is the weighted mean over the nine lines of voxels along it. The
// weights across are q, 1, q with 2q/(1 + 2q) = hmin^2/(2 h^2): the smoothing has the same world
// variance along each axis, that of 1 2 1 along the axis of the finest spacing hmin.
// A line with a missing end gives a one-sided difference, one without a pair of values nothing.
class SobelStencil
{
public:
  explicit SobelStencil(const ImageGrid& grid);

  // Gradients in world axes per world length of the row's voxels x0 to x1; 0 where the voxel has
  // no value. scalars: with NaN padding in x, and with the row's neighbours unless they are
  // outside the whole extent.
  void Row(const VoxelBox<double>& scalars, int x0, int x1, int y, int z, glm::dvec3* gradients) const;

private:
  bool FastRow(const VoxelBox<double>& scalars, int x0, int x1, int y, int z, glm::dvec3* gradients) const;
  glm::dvec3 AtIncomplete(const VoxelBox<double>& scalars, int x, int y, int z) const;
  double Along(int axis, const double (&values)[27]) const;

  glm::dvec3 Spacing;
  glm::dmat3 ToWorld;
  double Side[3]; // q
  double Norm[3]; // 1 / sum of the weights of the nine lines along the axis
};

// Unit normal -gradient/|gradient|, 0 where the gradient is 0, and the gradient's length; without
// overflow at gradients of 1e-300 to 1e300.
struct NormalAndMagnitude
{
  glm::dvec3 Normal;
  double Magnitude;
};
NormalAndMagnitude NormalOf(const glm::dvec3& gradient);
}

#endif
