// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The frame by a half angle against the eigenvectors of the covariance matrix; the ratio's logarithm.

#include "Check.h"
#include "Directions.h"
#include "Optics.h"

namespace
{
using glm::dvec2;
using glm::dvec3;

// C = [[tt, tp], [tp, pp]] in the plane's (theta, phi).
struct Covariance
{
  double tt;
  double tp;
  double pp;
};

dvec2 Anisotropy(const Covariance& c)
{
  return dvec2(c.tt - c.pp, 2.0 * c.tp) / (c.tt + c.pp);
}

// One Jacobi rotation diagonalises 2 x 2, no half angle: eigenvalues {larger, smaller}.
dvec2 Eigenvalues(const Covariance& c)
{
  if (c.tp == 0.0)
  {
    return dvec2(std::max(c.tt, c.pp), std::min(c.tt, c.pp));
  }
  const double q = (c.pp - c.tt) / (2.0 * c.tp);
  const double t = (q < 0.0 ? -1.0 : 1.0) / (std::abs(q) + std::sqrt(q * q + 1.0));
  const double first = c.tt - t * c.tp;
  const double second = c.pp + t * c.tp;
  return dvec2(std::max(first, second), std::min(first, second));
}

void CheckFrame(Check& check, const dvec3& normal, const Covariance& c)
{
  const dvec2 anisotropy = Anisotropy(c);
  const optics::AnisotropyFrame frame = optics::EigenFrame(normal, anisotropy);
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  const dvec2 u(glm::dot(frame.major, basis.theta), glm::dot(frame.major, basis.phi));
  const dvec2 l = Eigenvalues(c);
  const double size = l.x + l.y;
  // C U = l2 U is the definition; it holds however near the eigenvalues are
  const dvec2 cu(c.tt * u.x + c.tp * u.y, c.tp * u.x + c.pp * u.y);
  check.Near("C U = l2 U", glm::distance(cu, l.x * u) / size, 0.0, Rounding);
  check.Near("|U|", glm::length(frame.major), 1.0, Rounding);
  check.Near("U.V", glm::dot(frame.major, frame.minor), 0.0, Rounding);
  check.Near("U.n", glm::dot(frame.major, normal), 0.0, Rounding);
  check.Near("U x V = theta x phi",
    glm::distance(glm::cross(frame.major, frame.minor), glm::cross(basis.theta, basis.phi)), 0.0, Rounding);
  // 1 - |a| = 2 l1/(l1 + l2) has lost the digits of that ratio
  const double strength = (l.x - l.y) / size;
  if (strength < optics::LargestStrength)
  {
    check.Near("ln(l2/l1)", frame.logRatio, std::log(l.x / l.y), 10.0 * Rounding / (1.0 - strength));
  }
  else
  {
    check.Near("bounded ratio", frame.logRatio, std::log(1999.0), 1e-12); // 1 - .999: 13 digits
  }
}

void CheckKnownCases(Check& check)
{
  const dvec3 normal(0.0, 0.0, 1.0); // theta = x, phi = y
  const double third = 1.0 / 3.0;
  // C12 = 0 is not isotropic, against the text after [Ament2015] eq. 28
  check.Near("along theta", optics::EigenFrame(normal, dvec2(third, 0.0)).major.x, 1.0, 0.0);
  check.Near("along phi", optics::EigenFrame(normal, dvec2(-third, 0.0)).major.y, 1.0, 0.0);
  check.Near(
    "along phi, from below", std::abs(optics::EigenFrame(normal, dvec2(-third, -0.0)).major.y), 1.0, 0.0);
  check.Near("ratio 2", optics::EigenFrame(normal, dvec2(-third, 0.0)).logRatio, std::log(2.0), Rounding);
  const double diagonal = std::sqrt(0.5);
  check.Near("diagonal", optics::EigenFrame(normal, dvec2(0.0, third)).major.y, diagonal, Rounding);
  check.Near("other diagonal", optics::EigenFrame(normal, dvec2(0.0, -third)).major.y, -diagonal, Rounding);
  const optics::AnisotropyFrame none = optics::EigenFrame(normal, dvec2(0.0, 0.0));
  check.Near("isotropic ratio", none.logRatio, 0.0, 0.0);
  check.Near("isotropic frame", glm::length(none.major), 1.0, Rounding);

  // a small angle keeps its digits: the root of a difference would leave 1e-8 of an angle of 1e-10
  const optics::AnisotropyFrame small = optics::EigenFrame(normal, 0.5 * dvec2(1.0, 2e-10));
  check.Near("small angle", small.major.y, 1e-10, 1e-10 * Rounding);
}

void CheckLogRatio(Check& check)
{
  check.Near("ratio 1", optics::LogRatio(0.0), 0.0, 0.0);
  check.Near("ratio 9", optics::LogRatio(0.8), std::log(9.0), Rounding * 10.0);
  check.Near("2 atanh", optics::LogRatio(0.37), 2.0 * std::atanh(0.37), Rounding);
  check.Near("bound", optics::LogRatio(1.0), std::log(1999.0), 1e-12); // 1 - .999: 13 digits
  check.Near("roundings above 1", optics::LogRatio(1.01), optics::LogRatio(1.0), 0.0);
}
}

int TestEigenFrame(int, char*[])
{
  Check check;
  CheckKnownCases(check);
  CheckLogRatio(check);
  RandomDirections random(8);
  for (int i = 0; i < 20000; ++i)
  {
    // positive definite by its factor; ratios from 1 to 1e6
    const double scale = std::pow(10.0, random.Uniform(-12.0, 12.0));
    const double a = random.Normal();
    const double b = random.Normal();
    const double d = random.Normal() * std::pow(10.0, random.Uniform(-3.0, 0.0));
    CheckFrame(check, random.OnSphere(), { scale * a * a, scale * a * b, scale * (b * b + d * d) });
    CheckFrame(check, random.OnSphere(), { scale * a * a, 0.0, scale * b * b });
    CheckFrame(check, random.OnSphere(), { scale, scale * 1e-9 * a, scale * (1.0 + 1e-9 * b) });
  }
  CheckFrame(check, dvec3(0.0, 0.0, -1.0), { 1.0, 1.0, 1.0 });
  CheckFrame(check, dvec3(0.0, 0.0, 1.0), { 0.0, 0.0, 1.0 });
  return check.ExitCode();
}
