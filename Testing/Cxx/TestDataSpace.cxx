// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas of data space: closed cases, composition of segments, extremes.

#include "Check.h"
#include "Optics.h"

#include <limits>
#include <string>
#include <vector>

namespace
{
// The series of Opacity.glsl end where their next term is 4e-8 of the value; two of them.
constexpr double Series = 8.4e-8;

void CheckSegments(Check& check)
{
  check.Near("a segment of depth 1", optics::SegmentOpacity(4.0, 0.25), 1.0 - std::exp(-1.0), Rounding);
  for (double mean : { 0.0, 1e-30, 1.0, 1e8, 1e300 })
  {
    check.Near("no length", optics::SegmentOpacity(mean, 0.0), 0.0, 0.0);
    double former = 0.0;
    for (double length : { 0.0, 1e-300, 1e-8, 1e-3, 1.0, 1e30, 1e300 })
    {
      const double opacity = optics::SegmentOpacity(mean, length);
      check.AtLeast("monotone in the length", opacity, former);
      check.AtMost("opacity of a segment", opacity, 1.0);
      former = opacity;
    }
  }
  for (double x : { 0.0, 1e-30, 1e-3, 0.0099999, 0.0100001, 1.0, 50.0, 1e30 })
  {
    const double expected = x > 0.0 ? -std::expm1(-x) / x : 1.0;
    check.Near("(1 - exp(-x))/x", optics::OpacityOverDepth(x), expected, Series * expected);
  }
}

// Data space: only the change of the scalar counts.
void CheckScalarSteps(Check& check)
{
  const optics::vec3 gradient(3.0, 4.0, 0.0);
  check.Near("along the gradient", optics::ScalarStep(gradient, { 0.6, 0.8, 0.0 }), 5.0, Rounding);
  check.Near("against it", optics::ScalarStep(gradient, { -0.06, -0.08, 0.0 }), 0.5, Rounding);
  check.Near("across it", optics::ScalarStep(gradient, { 0.0, 0.0, 7.0 }), 0.0, 0.0);
  for (double scale : { 1e-30, 1e-6, 1.0, 1e6, 1e30 })
  {
    const double step = optics::ScalarStep(gradient / scale, scale * optics::vec3(0.3, 0.4, 0.5));
    check.Near("scale-invariant", step, 2.5, Rounding);
  }
  check.Near("the unit interval", optics::OpacityForScalarStep(0.3, 1.0), 0.3, Rounding);
  check.Near("two of them", optics::OpacityForScalarStep(0.5, 2.0), 0.75, Rounding);
  check.Near("no change of an opaque material", optics::OpacityForScalarStep(1.0, 0.0), 0.0, 0.0);
  check.Near("a change of it", optics::OpacityForScalarStep(1.0, 1e-3), 1.0, 0.0);
  check.Near("nothing", optics::OpacityForScalarStep(0.0, 1e30), 0.0, 0.0);
  for (double opacity : { 1e-12, 1e-3, 0.4, 0.999 })
  {
    const double half = optics::OpacityForScalarStep(opacity, 0.35);
    const double whole = optics::OpacityForScalarStep(opacity, 0.7);
    check.Near("two half steps", half + (1.0 - half) * half, whole, Series * whole);
  }
}

void CheckSurfaceSilhouettes(Check& check)
{
  for (double cosine : { 1.0, -1.0, 0.5, -0.25, 0.01 })
  {
    const double opacity = optics::SurfaceSilhouetteOpacity(0.3, cosine);
    check.Near("eq. 15", opacity, 1.0 - std::pow(0.7, 1.0 / std::abs(cosine)), Rounding);
    const double clamped = std::min(1.0, 0.3 / std::abs(cosine));
    check.Near("eq. 16", optics::ClampedSurfaceOpacity(0.3, cosine), clamped, Rounding);
  }
  for (double cosine : { 1.0, 0.3, 1e-30, 0.0, -0.0 })
  {
    check.Near("1 stays 1", optics::SurfaceSilhouetteOpacity(1.0, cosine), 1.0, 0.0);
    check.Near("1 stays 1, clamped", optics::ClampedSurfaceOpacity(1.0, cosine), 1.0, 0.0);
    check.Near("0 stays 0", optics::SurfaceSilhouetteOpacity(0.0, cosine), 0.0, 0.0);
    check.Near("0 stays 0, clamped", optics::ClampedSurfaceOpacity(0.0, cosine), 0.0, 0.0);
  }
  check.Near("grazing", optics::SurfaceSilhouetteOpacity(1e-12, 0.0), 1.0, 0.0);
  check.Near("grazing, clamped", optics::ClampedSurfaceOpacity(1e-12, 0.0), 1.0, 0.0);
}

// A smooth peak at an angle is the thin surface of its opacity: eq. 15 by eq. 17, without a cosine.
void CheckSmoothSilhouettes(Check& check)
{
  for (double mean : { 0.01, 1.0, 30.0 })
  {
    for (double cosine : { 1.0, 0.5, 0.02 })
    {
      const double opacity = optics::SegmentOpacity(mean, 0.2);
      check.Near("smooth and thin", optics::SilhouetteOpacity(mean, 0.2, 0.2 / cosine),
        optics::SurfaceSilhouetteOpacity(opacity, cosine), 2.0 * Series);
      check.Near("smooth and thin, clamped", optics::ClampedSilhouetteOpacity(mean, 0.2, 0.2 / cosine),
        optics::ClampedSurfaceOpacity(opacity, cosine), 2.0 * Series);
    }
    check.Near("a gradient less than its projection", optics::SilhouetteOpacity(mean, 0.2, 0.1),
      optics::SegmentOpacity(mean, 0.2), 0.0);
    // the ray runs along the surface
    check.Near(
      "no cosine", optics::SilhouetteOpacity(mean, 0.0, 0.5), optics::SegmentOpacity(mean, 0.5), 0.0);
    check.Near("no cosine, clamped", optics::ClampedSilhouetteOpacity(mean, 0.0, 0.5),
      std::min(1.0, mean * 0.5), Rounding);
  }
  for (double step : { 0.0, 1e-30, 1e30 })
  {
    const double opacity = optics::ClampedSilhouetteOpacity(1e30, step, 1e30);
    check.Near("bounded", opacity, 1.0, 1e-12);
    check.Near("nothing there", optics::ClampedSilhouetteOpacity(0.0, step, 1e30), 0.0, 0.0);
  }
}

void CheckTransmittedLight(Check& check)
{
  const optics::vec3 normal(0.0, 0.0, 1.0);
  const optics::vec3 viewer(0.0, 0.6, 0.8);
  const optics::vec3 behind(0.0, -0.6, -0.8);
  for (double sign : { 1.0, -1.0 })
  {
    optics::vec2 light = optics::TransmittedLight(sign * normal, behind, viewer, 7.0);
    check.Near("diffuse from behind", light.x, 0.8, Rounding);
    check.Near("specular from exactly behind", light.y, 1.0, Rounding);
    light = optics::TransmittedLight(sign * normal, { 0.0, 0.6, -0.8 }, viewer, 2.0);
    check.Near("diffuse from aside", light.x, 0.8, Rounding);
    check.Near("specular from aside", light.y, 0.28 * 0.28, Rounding);
    check.Near("behind", optics::ShareBehind(sign * normal, behind, viewer), 1.0, 0.0);
    check.Near("the viewer's side", optics::ShareBehind(sign * normal, { 0.0, -0.6, 0.8 }, viewer), 0.0, 0.0);
    check.Near("in the surface", optics::ShareBehind(sign * normal, { 1.0, 0.0, 0.0 }, viewer), 0.0, 0.0);
    const double half = 0.5 * optics::LightFade;
    check.Near(
      "a light that fades", optics::ShareBehind(sign * normal, { 1.0, 0.0, -half }, viewer), 0.5, Rounding);
  }
  check.Near("no normal", optics::ShareBehind(optics::vec3(0.0), behind, viewer), 0.0, 0.0);
}

// Composites what `steps` segments of a peak transmit, and without the share alpha (1 - alpha) of each.
struct Transmission
{
  double light = 0.0;
  double perSample = 0.0;
};
Transmission Transmit(double depth, int steps)
{
  Transmission sum;
  double transparency = 1.0;
  const double segment = depth / steps;
  for (int i = 0; i < steps; ++i)
  {
    const double alpha = optics::OneMinusExp(segment);
    const double behind = depth - (i + 1) * segment;
    sum.light += transparency * alpha * optics::TransmittedShare(segment, std::max(behind, 0.0), depth);
    sum.perSample += transparency * alpha * (1.0 - alpha);
    transparency *= 1.0 - alpha;
  }
  return sum;
}

void CheckTransmittedShare(Check& check)
{
  for (double opacity : { 1e-9, 0.1, 0.5, 0.9, 0.999999 })
  {
    for (int steps : { 1, 2, 7, 64, 1000 })
    {
      const double light = Transmit(-std::log1p(-opacity), steps).light;
      check.Near("transmitted in " + std::to_string(steps) + " steps", light, opacity * (1.0 - opacity),
        4.0 * Series * opacity);
    }
  }
  // what it is for: eq. 19 by samples depends on their number
  check.Near("a peak of .5 in one sample", Transmit(std::log(2.0), 1).perSample, 0.25, 1e-9);
  check.Near("a peak of .5 in 64", Transmit(std::log(2.0), 64).perSample, 0.495, 0.003);
  check.Near("a peak of .9 in 64", Transmit(std::log(10.0), 64).perSample, 0.87, 0.02);
  check.Near("an opaque peak", optics::TransmittedShare(1e30, 1e30, 1e30), 0.0, 0.0);
  check.Near("opaque behind", optics::TransmittedShare(0.1, 1e4, 1e4), 0.0, 0.0);
  check.Near("nothing", optics::TransmittedShare(0.0, 0.0, 0.0), 1.0, 0.0);
  check.Near("a peak that is not known", optics::TransmittedShare(0.7, 0.0, 0.0), std::exp(-0.7), Rounding);
}

int Crossings(const std::vector<double>& path, double isovalue)
{
  int count = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    count += optics::CrossesIsovalue(path[i], path[i + 1], isovalue) ? 1 : 0;
  }
  return count;
}

void CheckCrossings(Check& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check.That(Crossings({ 0.0, 1.0 }, 0.5) == 1, "a crossing");
  check.That(Crossings({ 1.0, 0.0 }, 0.5) == 1, "a crossing downwards");
  check.That(Crossings({ 0.0, 0.5, 1.0 }, 0.5) == 1, "met at a sample");
  check.That(Crossings({ 1.0, 0.5, 0.0 }, 0.5) == 1, "met at a sample downwards");
  check.That(Crossings({ 0.0, 0.5, 0.5, 0.5, 1.0 }, 0.5) == 1, "along the surface");
  check.That(Crossings({ 1.0, 0.5, 1.0 }, 0.5) == 0, "touched from above");
  check.That(Crossings({ 0.0, 0.5, 0.0 }, 0.5) == 2, "touched from below: in and out");
  check.That(Crossings({ 0.5, 0.5 }, 0.5) == 0, "a constant");
  check.That(Crossings({ 0.0, nan, 1.0 }, 0.5) == 0, "no number");
  check.Near("a quarter", optics::CrossingFraction(2.0, 6.0, 3.0), 0.25, 0.0);
  check.Near("downwards", optics::CrossingFraction(6.0, 2.0, 3.0), 0.75, 0.0);
  check.Near("no change", optics::CrossingFraction(2.0, 2.0, 2.0), 0.0, 0.0);
  check.Near("small", optics::CrossingFraction(1e-30, 5e-30, 2e-30), 0.25, Rounding);
  check.Near("large", optics::CrossingFraction(-1e30, 1e30, 0.0), 0.5, 0.0);
  check.Near("the first entry's middle", optics::TableCoordinate(0.0, 4.0), 0.125, 0.0);
  check.Near("the last entry's middle", optics::TableCoordinate(1.0, 4.0), 0.875, 0.0);
  check.Near("outside", optics::TableCoordinate(7.0, 4.0), 0.875, 0.0);
}
}

int TestDataSpace(int, char*[])
{
  Check check;
  CheckSegments(check);
  CheckScalarSteps(check);
  CheckSurfaceSilhouettes(check);
  CheckSmoothSilhouettes(check);
  CheckTransmittedLight(check);
  CheckTransmittedShare(check);
  CheckCrossings(check);
  return check.ExitCode();
}
