// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The rule by which the gallery's scores match the models (docs/scores.md): for Blinn-Phong's exponent n,
// Lafortune's n/4 and Ward's roughness sqrt(2/n) make highlights of one size on a sphere.

#include "Check.h"
#include "Optics.h"

#include <cmath>
#include <functional>

namespace
{
using glm::dvec3;

const dvec3 Normal(0.0, 0.0, 1.0);
const dvec3 Major(1.0, 0.0, 0.0);
const dvec3 Minor(0.0, 1.0, 0.0);

// Angle from the centre of a sphere's highlight, light behind the viewer, at which half of it is left.
double HalfWidth(const std::function<double(const dvec3&)>& reflection)
{
  const double peak = reflection(Normal);
  double inside = 0.0, outside = 1.5;
  while (outside - inside > 1e-9)
  {
    const double angle = 0.5 * (inside + outside);
    const double value = reflection(dvec3(std::sin(angle), 0.0, std::cos(angle)));
    (value > 0.5 * peak ? inside : outside) = angle;
  }
  return inside;
}

void CheckExponent(Check& check, double n, double tolerance)
{
  const double blinnPhong =
    HalfWidth([&](const dvec3& l) { return optics::BlinnPhongReflection(Normal, l, l, n); });
  const double kappa = std::sqrt(2.0 / n);
  const double ward = HalfWidth(
    [&](const dvec3& l) { return optics::WardReflection(Normal, Major, Minor, l, l, kappa, kappa); });
  const double weight = optics::LafortuneMajorWeight(0.0, 0.0);
  const double lafortune = HalfWidth(
    [&](const dvec3& l) { return optics::LafortuneReflection(Normal, Major, Minor, l, l, weight, n / 4.0); });
  const std::string name = ", exponent " + std::to_string(n);
  check.Near("Ward / Blinn-Phong" + name, ward / blinnPhong, 1.0, tolerance);
  check.Near("Lafortune / Blinn-Phong" + name, lafortune / blinnPhong, 1.0, tolerance);
}
}

int TestHighlightSize(int, char*[])
{
  Check check;
  CheckExponent(check, 10.0, 0.05);
  CheckExponent(check, 80.0, 0.01);
  CheckExponent(check, 1000.0, 0.001);
  return check.ExitCode();
}
