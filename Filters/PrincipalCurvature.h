// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Principal curvatures of the isosurface through a voxel, as an anisotropy of its tangent plane.

#ifndef PrincipalCurvature_h
#define PrincipalCurvature_h

#include "VoxelBox.h"

namespace volumeoptics
{
// Second derivatives in world axes of the voxels of a row, by central differences; a derivative with
// a neighbour missing counts as 0. scalars: with NaN padding in x and neighbours as for SobelStencil.
class HessianRow
{
public:
  HessianRow(const ImageGrid& grid, const VoxelBox<double>& scalars, int y, int z);

  glm::dmat3 At(int x) const;

private:
  double Value(int x, int dy, int dz) const
  {
    const double* row = this->Rows[4 + dy + 3 * dz];
    return row ? row[x - this->FirstX] : NoValue<double>();
  }
  double SecondDifference(int x, int a, int b) const;

  const ImageGrid& Grid;
  const double* Rows[9]; // null outside
  int FirstX;
};

// Curvature of the isosurface in the tangent basis (theta, phi): (tt, tp, pp) of the geometry tensor
// of [Kindlmann2003], -P H P/|grad s|. normal: unit, -grad s/|grad s|.
glm::dvec3 TangentCurvature(const glm::dvec3& normal, double magnitude, const glm::dmat3& hessian);

// Highlights run along the direction of the smaller |k|. Strength (|k1| - |k2|)/(|k1| + |k2|) for
// |k1| >= |k2|: 1 on a cylinder, 0 on a sphere, a plane and a symmetric saddle. With the mean m
// and the deviation d of the two curvatures m + |d|, m - |d| it is min(|m|, |d|)/max(|m|, |d|).
// tangentCurvature: per voxel. Curvatures far below 1e-4, a radius of 10,000 voxels, are rounding
// errors of a plane and fade out.
glm::dvec2 AnisotropyOfCurvature(const glm::dvec3& tangentCurvature);
}

#endif
