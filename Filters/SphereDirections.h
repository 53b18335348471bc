// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Directions to integrate over the sphere with.

#ifndef SphereDirections_h
#define SphereDirections_h

#include <glm/glm.hpp>

#include <vector>

namespace volumeoptics
{
struct WeightedDirection
{
  glm::dvec3 Direction; // unit
  double Weight;        // solid angle; all together 4 pi
};

// The octahedron's faces, each parted in four `subdivisions` times: 8 4^n centres with their spherical
// areas ([Schussman2004] section 5 takes 2 and 3).
std::vector<WeightedDirection> OctahedronDirections(int subdivisions);

// Gauss' rule in z, equal steps in azimuth: 2 rows^2 directions, exact to degree 2 rows - 1.
std::vector<WeightedDirection> GaussDirections(int rows);
}

#endif
