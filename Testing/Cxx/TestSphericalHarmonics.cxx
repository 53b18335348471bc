// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Real spherical harmonics to l = 12: closed cases, orthonormal, addition theorem; Wallis' integral and
// the zonal coefficients of powers of the sine against quadrature.

#include "Check.h"
#include "Directions.h"
#include "LineQuadrature.h"
#include "Optics.h"

#include <string>
#include <vector>

namespace
{
const int LargestOrder = 12;

void CheckClosedCases(Check& check)
{
  RandomDirections random(3);
  for (int i = 0; i < 50; ++i)
  {
    const glm::dvec3 d = random.OnSphere();
    const double pi = TwoPi / 2.0;
    check.Near("Y00", optics::SphericalHarmonic(0, 0, d), std::sqrt(0.25 / pi), Rounding);
    check.Near("Y10", optics::SphericalHarmonic(1, 0, d), std::sqrt(0.75 / pi) * d.z, Rounding);
    check.Near("Y11", optics::SphericalHarmonic(1, 1, d), -std::sqrt(0.75 / pi) * d.x, Rounding);
    check.Near("Y1-1", optics::SphericalHarmonic(1, -1, d), -std::sqrt(0.75 / pi) * d.y, Rounding);
    check.Near("Y2-2", optics::SphericalHarmonic(2, -2, d), std::sqrt(3.75 / pi) * d.x * d.y, Rounding);
    check.Near("Y40", optics::SphericalHarmonic(4, 0, d),
      3.0 / 16.0 / std::sqrt(pi) * (35.0 * std::pow(d.z, 4.0) - 30.0 * d.z * d.z + 3.0), Rounding);
  }
}

// Gauss' rule in z and equal steps in azimuth are exact to degree 24.
void CheckOrthonormal(Check& check)
{
  const std::vector<SphereNode> nodes = GaussSphere(16, 32);
  const int count = (LargestOrder + 1) * (LargestOrder + 1);
  std::vector<double> products(count * count, 0.0);
  std::vector<double> values(count);
  for (const SphereNode& node : nodes)
  {
    for (int l = 0; l <= LargestOrder; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        values[l * (l + 1) + m] = optics::SphericalHarmonic(l, m, node.Direction);
      }
    }
    for (int i = 0; i < count; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        products[i * count + j] += node.Weight * values[i] * values[j];
      }
    }
  }
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      check.Near("product of " + std::to_string(i) + " and " + std::to_string(j), products[i * count + j],
        i == j ? 1.0 : 0.0, 100.0 * Rounding);
    }
  }
}

// sum_m Y_lm(a) Y_lm(b) = (2l + 1)/(4 pi) P_l(a.b).
void CheckAdditionTheorem(Check& check)
{
  RandomDirections random(4);
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 a = random.OnSphere(), b = i == 0 ? a : random.OnSphere();
    for (int l = 0; l <= LargestOrder; ++l)
    {
      double sum = 0.0;
      for (int m = -l; m <= l; ++m)
      {
        sum += optics::SphericalHarmonic(l, m, a) * optics::SphericalHarmonic(l, m, b);
      }
      check.Near("addition theorem, l = " + std::to_string(l), sum,
        (2.0 * l + 1.0) / (2.0 * TwoPi) * std::legendre(l, glm::dot(a, b)), 100.0 * Rounding);
    }
  }
}

void CheckMoments(Check& check)
{
  check.Near("n = 0", optics::WallisIntegral(0.0), TwoPi / 2.0, 1e-12);
  check.Near("n = 1", optics::WallisIntegral(1.0), 2.0, 1e-12);
  check.Near("n = 2", optics::WallisIntegral(2.0), TwoPi / 4.0, 1e-12);
  for (double power : { 1.0, 2.0, 3.0, 2.5, 11.0, 33.0, 101.0, 1001.0 })
  {
    for (int l = 0; l <= LargestOrder; ++l)
    {
      const double quadrature = Integrate(
        [&](double t) { return std::pow(std::sin(t), power + 1.0) * std::legendre(l, std::cos(t)); }, 0.0,
        TwoPi / 2.0);
      // 1e-13: the first term that Wallis' series leaves out
      check.Near("moment, l = " + std::to_string(l) + ", power = " + std::to_string(power),
        optics::SineMoment(l, power), quadrature, 1e-12);
    }
  }
}
}

int TestSphericalHarmonics(int, char*[])
{
  Check check;
  CheckClosedCases(check);
  CheckOrthonormal(check);
  CheckAdditionTheorem(check);
  CheckMoments(check);
  return check.ExitCode();
}
