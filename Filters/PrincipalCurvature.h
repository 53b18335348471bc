// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Principal curvatures of the isosurface through a voxel, as an anisotropy of its tangent plane.

#ifndef PrincipalCurvature_h
#define PrincipalCurvature_h

#include "VoxelBox.h"

namespace volumeoptics
{
// Second derivatives in world axes by central differences; a derivative with a neighbour missing
// counts as 0. scalars: with NaN padding in x and neighbours as for SobelStencil. The voxel has a
// value.
glm::dmat3 HessianAt(const ImageGrid& grid, const VoxelBox<double>& scalars, int x, int y, int z);

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
