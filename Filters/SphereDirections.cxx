// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SphereDirections.h"

#include "Optics.h"

#include <cmath>

namespace volumeoptics
{
namespace
{
// tan(area/2) = |a.(b x c)|/(1 + a.b + b.c + c.a).
double SphericalArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const double volume = std::abs(glm::dot(a, glm::cross(b, c)));
  return 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

void Subdivide(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int times,
  std::vector<WeightedDirection>& directions)
{
  if (times == 0)
  {
    directions.push_back({ glm::normalize(a + b + c), SphericalArea(a, b, c) });
    return;
  }
  const glm::dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
  Subdivide(a, ab, ca, times - 1, directions);
  Subdivide(ab, b, bc, times - 1, directions);
  Subdivide(ca, bc, c, times - 1, directions);
  Subdivide(ab, bc, ca, times - 1, directions);
}

// P_n and its derivative.
glm::dvec2 Legendre(int n, double x)
{
  double value = 1.0, before = 0.0;
  for (int l = 1; l <= n; ++l)
  {
    const double next = ((2.0 * l - 1.0) * x * value - (l - 1.0) * before) / l;
    before = value;
    value = next;
  }
  return { value, n * (x * value - before) / (x * x - 1.0) };
}
}

std::vector<WeightedDirection> OctahedronDirections(int subdivisions)
{
  std::vector<WeightedDirection> directions;
  for (int octant = 0; octant < 8; ++octant)
  {
    const glm::dvec3 signs(octant & 1 ? -1.0 : 1.0, octant & 2 ? -1.0 : 1.0, octant & 4 ? -1.0 : 1.0);
    Subdivide(glm::dvec3(signs.x, 0.0, 0.0), glm::dvec3(0.0, signs.y, 0.0), glm::dvec3(0.0, 0.0, signs.z),
      subdivisions, directions);
  }
  return directions;
}

std::vector<WeightedDirection> GaussDirections(int rows)
{
  std::vector<WeightedDirection> directions;
  for (int i = 0; i < rows; ++i)
  {
    double z = std::cos(2.0 * optics::QuarterTurn * (i + 0.75) / (rows + 0.5));
    for (int step = 0; step < 8; ++step) // Newton's, from a good start
    {
      const glm::dvec2 polynomial = Legendre(rows, z);
      z -= polynomial.x / polynomial.y;
    }
    const double slope = Legendre(rows, z).y;
    const double rho = std::sqrt(1.0 - z * z);
    const double weight = 2.0 / (rho * rho * slope * slope) * 2.0 * optics::QuarterTurn / rows;
    for (int j = 0; j < 2 * rows; ++j)
    {
      const double azimuth = 2.0 * optics::QuarterTurn * (j + 0.5) / rows;
      directions.push_back({ { rho * std::cos(azimuth), rho * std::sin(azimuth), z }, weight });
    }
  }
  return directions;
}
}
