// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Opacity and optical depth: closed cases, composition of lengths, extremes.

#include "Check.h"
#include "Optics.h"

namespace
{
// Both series end below .01 where their next term is x^3/24 = 4e-8 of the value.
constexpr double Series = 4.2e-8;

void CheckInverses(Check& check)
{
  for (double x : { 0.0, 1e-300, 1e-30, 1e-12, 1e-6, 1e-3, 0.0099, 0.01, 0.0101, 0.1, 1.0, 6.9, 30.0 })
  {
    const double opacity = optics::OneMinusExp(x);
    check.Near("1 - exp(-x)", opacity, -std::expm1(-x), Series * -std::expm1(-x));
  }
  for (double a :
    { 0.0, 1e-300, 1e-30, 1e-12, 1e-6, 1e-3, 0.0099, 0.01, 0.0101, 0.1, 0.5, 0.999, 1.0 - 1e-15 })
  {
    check.Near("-ln(1 - a)", optics::OpticalDepth(a), -std::log1p(-a), Series * -std::log1p(-a));
  }
  check.Near("opaque in any precision", optics::OneMinusExp(1e4), 1.0, 0.0);
  check.Finite("depth of an opaque material", optics::OpticalDepth(1.0));
}

void CheckLengths(Check& check)
{
  for (double length : { 0.0, 1e-30, 1e-6, 0.3, 1.0, 7.0, 1e30 })
  {
    check.Near("1 stays 1", optics::OpacityForLength(1.0, length), 1.0, 0.0);
    check.Near("0 stays 0", optics::OpacityForLength(0.0, length), 0.0, 0.0);
  }
  check.Near("two lengths of a half", optics::OpacityForLength(0.5, 2.0), 0.75, Rounding);
  check.Near("half a length", optics::OpacityForLength(0.75, 0.5), 0.5, Rounding);
  check.Near("tiny opacity", optics::OpacityForLength(1e-12, 0.25), 2.5e-13, 1e-24);
  check.Near(
    "tiny opacity over a long way", optics::OpacityForLength(1e-12, 1e12), 1.0 - std::exp(-1.0), 1e-12);
  for (double opacity : { 1e-12, 1e-4, 0.005, 0.02, 0.3, 0.9, 0.999999 })
  {
    check.Near("the same length", optics::OpacityForLength(opacity, 1.0), opacity, 2.0 * Series * opacity);
    check.Near("no length", optics::OpacityForLength(opacity, 0.0), 0.0, 0.0);
    for (double length : { 1e-3, 0.1, 1.0, 3.0, 50.0 })
    {
      const double whole = optics::OpacityForLength(opacity, length);
      const double half = optics::OpacityForLength(opacity, length / 2.0);
      check.Near("two half lengths", half + (1.0 - half) * half, whole, 4.0 * Series * whole);
      check.AtMost("opacity", whole, 1.0);
      check.AtLeast("monotone in the length", whole, half);
    }
  }
}

void CheckSpecularCoefficient(Check& check)
{
  check.Near(
    "bounded depth", optics::BoundedOpticalDepth(1.0), std::log(1000.0), 1e-12); // 1 - .999: 13 digits
  check.Near("depth within the bound", optics::BoundedOpticalDepth(0.5), std::log(2.0), Rounding);
  check.Near("depth of a negative opacity", optics::BoundedOpticalDepth(-1.0), 0.0, 0.0);
  check.Near("gradient", optics::SpecularCoefficient(0.75, 0.25, 2.0), 0.5, 0.0);
  check.Near("gradient, turned", optics::SpecularCoefficient(0.25, 0.75, 2.0), 0.5, 0.0);
  check.Near("no gradient", optics::SpecularCoefficient(6.9, 6.9, 1e30), 0.0, 0.0);
  check.Near("bound", optics::SpecularCoefficient(6.9, 0.0, 1e30), 16.0, 0.0);

  // D |grad tau| with tau = depth per D along a linear ramp: the world's scale cancels
  const double slope = 0.2; // depth per voxel at D = 1 voxel
  for (double scale : { 1e-6, 1.0, 1e6 })
  {
    const double spacing = scale;
    const double unitDistance = scale;
    const double ks = optics::SpecularCoefficient(3.0 * slope, 1.0 * slope, unitDistance / spacing);
    check.Near("scale-free", ks, slope, Rounding);
  }
  const double jump = optics::SpecularCoefficient(optics::BoundedOpticalDepth(1.0), 0.0, 1.0);
  check.Near("jump from nothing to opaque", jump, 3.45, 0.01); // the figure in Opacity.glsl, in two digits
}
}

int TestOpacity(int, char*[])
{
  Check check;
  CheckInverses(check);
  CheckLengths(check);
  CheckSpecularCoefficient(check);
  return check.ExitCode();
}
