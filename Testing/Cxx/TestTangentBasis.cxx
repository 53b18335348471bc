// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The bases of the tangent plane: orthonormal everywhere, the poles and their surroundings included.

#include "Check.h"
#include "Directions.h"
#include "Optics.h"
#include "OpticsFloat.h"

namespace
{
using glm::dvec3;

void CheckOrthonormal(Check& check, const std::string& what, const dvec3& normal, const dvec3& theta,
  const dvec3& phi, double tolerance)
{
  check.Near(what + " |theta|", glm::length(theta), 1.0, tolerance);
  check.Near(what + " |phi|", glm::length(phi), 1.0, tolerance);
  check.Near(what + " theta.phi", glm::dot(theta, phi), 0.0, tolerance);
  check.Near(what + " theta.n", glm::dot(theta, normal), 0.0, tolerance);
  check.Near(what + " phi.n", glm::dot(phi, normal), 0.0, tolerance);
}

void CheckNormal(Check& check, const dvec3& normal)
{
  // 1e-15 of a normal that counts as the pole, and a few roundings
  const double roundings = 2e-15;
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  CheckOrthonormal(check, "double", normal, basis.theta, basis.phi, roundings);
  // phi is eta1 of eq. 20, theta is eta2 = eta1 x n of eq. 21
  check.Near("eta2", glm::distance(basis.theta, glm::cross(basis.phi, normal)), 0.0, roundings);

  const optics::TangentBasis image = optics::SquaredBasis(normal);
  CheckOrthonormal(check, "image", glm::cross(image.theta, image.phi), image.theta, image.phi, roundings);

  // the same in float: 6e-8 a rounding, of the normal's, too
  const glm::vec3 n(normal);
  const opticsFloat::TangentBasis single = opticsFloat::SphericalBasis(n);
  CheckOrthonormal(check, "float", dvec3(n), dvec3(single.theta), dvec3(single.phi), 4e-7);
  const opticsFloat::AnisotropyFrame frame = opticsFloat::EigenFrame(n, glm::vec2(normal.x, normal.y));
  CheckOrthonormal(check, "float frame", dvec3(n), dvec3(frame.major), dvec3(frame.minor), 6e-7);
}
}

int TestTangentBasis(int, char*[])
{
  Check check;
  for (double sign : { -1.0, 1.0 })
  {
    CheckNormal(check, dvec3(0.0, 0.0, sign));
    // down to where squares are subnormal: 1e-19 and below in float, 1e-154 in double
    for (double exponent = -320.0; exponent < -0.5; exponent += 0.25)
    {
      const double rho = std::pow(10.0, exponent);
      for (double azimuth : { 0.0, 0.1, 0.8, 1.9, 3.0, 4.5, 6.0 })
      {
        CheckNormal(
          check, dvec3(rho * std::cos(azimuth), rho * std::sin(azimuth), sign * std::sqrt(1.0 - rho * rho)));
      }
    }
  }
  RandomDirections random(4);
  for (int i = 0; i < 10000; ++i)
  {
    CheckNormal(check, random.OnSphere());
  }
  return check.ExitCode();
}
