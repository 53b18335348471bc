// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrincipalCurvature.h"

#include "Optics.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
const double NegligibleCurvature = 1.0e-4;

double Value(const VoxelBox<double>& scalars, const glm::ivec3& place)
{
  return scalars.HasRow(place.y, place.z) ? *scalars.At(place.x, place.y, place.z)
                                          : NoValue<double>();
}

// Times the two spacings.
double SecondDifference(const VoxelBox<double>& scalars, const glm::ivec3& place, int a, int b)
{
  glm::ivec3 alongA(0);
  glm::ivec3 alongB(0);
  alongA[a] = 1;
  alongB[b] = 1;
  if (a == b)
  {
    const double centre = Value(scalars, place);
    return (Value(scalars, place + alongA) - centre) - (centre - Value(scalars, place - alongA));
  }
  const double ahead =
    Value(scalars, place + alongA + alongB) - Value(scalars, place - alongA + alongB);
  const double behind =
    Value(scalars, place + alongA - alongB) - Value(scalars, place - alongA - alongB);
  return (ahead - behind) / 4.0;
}
}

glm::dmat3 HessianAt(const ImageGrid& grid, const VoxelBox<double>& scalars, int x, int y, int z)
{
  glm::dmat3 hessian(0.0);
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b <= a; ++b)
    {
      const double difference = SecondDifference(scalars, glm::ivec3(x, y, z), a, b);
      const double derivative = difference / grid.Spacing[a] / grid.Spacing[b];
      hessian[a][b] = std::isfinite(derivative) ? derivative : 0.0;
      hessian[b][a] = hessian[a][b];
    }
  }
  return grid.GradientToWorld * hessian * glm::transpose(grid.GradientToWorld);
}

glm::dvec3 TangentCurvature(const glm::dvec3& normal, double magnitude, const glm::dmat3& hessian)
{
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  const glm::dvec3 alongTheta = hessian * basis.theta;
  return -glm::dvec3(glm::dot(basis.theta, alongTheta), glm::dot(basis.phi, alongTheta),
           glm::dot(basis.phi, hessian * basis.phi)) / magnitude;
}

glm::dvec2 AnisotropyOfCurvature(const glm::dvec3& k)
{
  const double mean = k.x / 2.0 + k.z / 2.0;
  const glm::dvec2 deviation(k.x / 2.0 - k.z / 2.0, k.y);
  const double length = std::hypot(deviation.x, deviation.y);
  const double larger = std::max(std::abs(mean), length) + NegligibleCurvature;
  if (!(length > 0.0) || !std::isfinite(larger))
  {
    return glm::dvec2(0.0);
  }
  const double strength = std::min(std::abs(mean), length) / larger;
  // The direction of the larger eigenvalue is the one of smaller |k| if the mean is negative.
  return deviation / length * (mean > 0.0 ? -strength : strength);
}
}
