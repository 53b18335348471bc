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
}

HessianRow::HessianRow(const ImageGrid& grid, const VoxelBox<double>& scalars, int y, int z)
  : Grid(grid)
  , FirstX(scalars.GetBox()[0])
{
  for (int i = 0; i < 9; ++i)
  {
    const int rowY = y + i % 3 - 1;
    const int rowZ = z + i / 3 - 1;
    this->Rows[i] = scalars.HasRow(rowY, rowZ) ? scalars.Row(rowY, rowZ) : nullptr;
  }
}

// Times the two spacings.
double HessianRow::SecondDifference(int x, int a, int b) const
{
  auto value = [this, x, a, b](int stepA, int stepB) {
    int step[3] = { 0, 0, 0 };
    step[a] += stepA;
    step[b] += stepB;
    return this->Value(x + step[0], step[1], step[2]);
  };
  if (a == b)
  {
    const double centre = value(0, 0);
    return (value(1, 0) - centre) - (centre - value(-1, 0));
  }
  return ((value(1, 1) - value(-1, 1)) - (value(1, -1) - value(-1, -1))) / 4.0;
}

glm::dmat3 HessianRow::At(int x) const
{
  glm::dmat3 hessian(0.0);
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b <= a; ++b)
    {
      const double difference = this->SecondDifference(x, a, b);
      const double derivative = difference / this->Grid.Spacing[a] / this->Grid.Spacing[b];
      hessian[a][b] = std::isfinite(derivative) ? derivative : 0.0;
      hessian[b][a] = hessian[a][b];
    }
  }
  return this->Grid.GradientToWorld * hessian * glm::transpose(this->Grid.GradientToWorld);
}

glm::dvec3 TangentCurvature(const glm::dvec3& normal, double magnitude, const glm::dmat3& hessian)
{
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  const glm::dvec3 alongTheta = hessian * basis.theta;
  return -glm::dvec3(glm::dot(basis.theta, alongTheta), glm::dot(basis.phi, alongTheta),
           glm::dot(basis.phi, hessian * basis.phi)) /
    magnitude;
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
