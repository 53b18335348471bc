// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Henyey-Greenstein: normalised to 4 pi, mean cosine g, symmetric, finite at |g| = 1.

#include "Check.h"
#include "Optics.h"

namespace
{
struct Moments
{
  double Mean = 0.0;       // over the sphere: 1 for an integral of 4 pi
  double MeanCosine = 0.0; // weighted with the function
};

// Midpoint rule in s, 1 - |cos| = 2 s^4 towards the peak: the peak's width of (1 - g)^2 = 1e-6 at
// g = .999 is then .03 of the range of s.
Moments Integrate(double g)
{
  const int steps = 200000;
  const double sign = g < 0.0 ? -1.0 : 1.0;
  Moments moments;
  for (int i = 0; i < steps; ++i)
  {
    const double s = (i + 0.5) / steps;
    const double cosine = sign * (1.0 - 2.0 * s * s * s * s);
    const double weight = 0.5 * 8.0 * s * s * s / steps;
    const double value = optics::HenyeyGreenstein(g, cosine);
    moments.Mean += weight * value;
    moments.MeanCosine += weight * value * cosine;
  }
  return moments;
}

void CheckMoments(Check& check)
{
  // quadrature: second order in a step of 5e-6 relative to a peak of width .03
  const double quadrature = 1e-6;
  for (double g : { -0.999, -0.9, -0.3, -1e-3, 0.0, 1e-6, 0.1, 0.5, 0.76, 0.95, 0.99, 0.999 })
  {
    const Moments moments = Integrate(g);
    check.Near("mean over the sphere, g = " + std::to_string(g), moments.Mean, 1.0, quadrature);
    check.Near("mean cosine, g = " + std::to_string(g), moments.MeanCosine, g, quadrature);
  }
}

void CheckClosedCases(Check& check)
{
  for (double cosine = -1.0; cosine <= 1.0; cosine += 0.125)
  {
    check.Near("isotropic", optics::HenyeyGreenstein(0.0, cosine), 1.0, 0.0);
    for (double g : { 0.2, 0.7, 0.999, 1.0 })
    {
      const double value = optics::HenyeyGreenstein(g, cosine);
      check.Near("symmetry in (g, cos)", optics::HenyeyGreenstein(-g, -cosine), value, 0.0);
      check.Finite("value", value);
      check.AtLeast("value", value, 0.0);
    }
  }
  for (double g : { 0.2, 0.7, 0.95 })
  {
    // 1 - g has lost 1/(1 - g) of its digits, the value takes the square of it
    const double peak = (1.0 + g) / ((1.0 - g) * (1.0 - g));
    check.Near("forward peak", optics::HenyeyGreenstein(g, 1.0), peak, Rounding * peak * 10.0);
    const double back = (1.0 - g) / ((1.0 + g) * (1.0 + g));
    check.Near("backward", optics::HenyeyGreenstein(g, -1.0), back, Rounding);
    const double side = (1.0 - g * g) / std::pow(1.0 + g * g, 1.5);
    check.Near("sideways", optics::HenyeyGreenstein(g, 0.0), side, Rounding);
  }
  // 1.999/1e-6 at the bound of .999
  check.Near("peak of g = 1", optics::HenyeyGreenstein(1.0, 1.0), 1.999e6, 1.0);
  // a dot product of two unit vectors may exceed 1 by its roundings
  check.Finite("cosine above 1", optics::HenyeyGreenstein(1.0, 1.0000003));
  check.Finite("cosine below -1", optics::HenyeyGreenstein(-1.0, -1.0000003));
}
}

int TestPhaseFunction(int, char*[])
{
  Check check;
  CheckMoments(check);
  CheckClosedCases(check);
  return check.ExitCode();
}
