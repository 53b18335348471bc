// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// White furnace: what Ward's lobe reflects of light from all sides, and how a wide lobe dims. Why
// LargestRoughness bounds the major axis.

#include "Check.h"
#include "Directions.h"
#include "Optics.h"

namespace
{
using glm::dvec3;

const dvec3 Normal(0.0, 0.0, 1.0);

// Share of the radiance of an even surrounding that reaches the viewer. The midpoint rule over
// (polar, azimuth) with 1000 x 400 points is good to 1e-3 for roughness .2 and more.
double Albedo(double polarOfViewer, double u, double w, bool published)
{
  const int polars = 1000;
  const int azimuths = 400;
  const dvec3 viewer = Direction(polarOfViewer, 0.0);
  double sum = 0.0;
  for (int i = 0; i < polars; ++i)
  {
    const double polar = (i + 0.5) / polars * TwoPi / 4.0;
    for (int k = 0; k < azimuths; ++k)
    {
      const dvec3 light = Direction(polar, (k + 0.5) / azimuths * TwoPi);
      double value =
        optics::WardReflection(Normal, dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0), light, viewer, u, w);
      if (published)
      {
        value *= std::max(light.z, viewer.z) / std::sqrt(light.z * viewer.z);
      }
      sum += value * std::sin(polar);
    }
  }
  return sum * (TwoPi / 4.0 / polars) * (TwoPi / azimuths);
}
}

int TestWardAlbedo(int, char*[])
{
  Check check;
  // the figures of methods and of Reflectance.glsl, of the published form at normal incidence, in two digits
  check.Near("albedo at .2", Albedo(0.0, 0.2, 0.2, true), 0.895, 0.005);
  check.Near("albedo at 5", Albedo(0.0, 5.0, 0.2, true), 0.11, 0.005);
  std::cout << "albedo at normal incidence, minor roughness .2: major, published, ours" << std::endl;
  double last = 2.0;
  for (double u : { 0.2, 0.4, 1.0, 2.0, 4.0, 5.0 })
  {
    const double published = Albedo(0.0, u, 0.2, true);
    const double ours = Albedo(0.0, u, 0.2, false);
    std::cout << u << ' ' << published << ' ' << ours << std::endl;
    check.AtMost("white furnace", published, 1.0);
    check.AtMost("the bounded form reflects no more", ours, published + 1e-9);
    check.AtMost("a wider lobe dims", published, last);
    last = published;
  }
  for (double polar : { 0.3, 0.8, 1.2, 1.5 })
  {
    const double ours = Albedo(polar, 0.2, 0.2, false);
    std::cout << "isotropic .2, viewer at " << polar << ": " << Albedo(polar, 0.2, 0.2, true) << ' ' << ours
              << std::endl;
    check.AtMost("white furnace off the normal", ours, 1.0);
  }
  return check.ExitCode();
}
