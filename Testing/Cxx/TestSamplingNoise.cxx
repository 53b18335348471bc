// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Few samples of an isotropic disk look anisotropic; WithoutSamplingNoise takes that off and leaves
// what is there.

#include "Check.h"
#include "Directions.h"
#include "Optics.h"

#include <vector>

namespace
{
using glm::dvec2;

// The anisotropy of `count` points of an ellipse with half axes (axis, 1), weighted by 1 - d^2 about
// the centroid ([Ament2015] eqs 23 to 25).
dvec2 Estimate(RandomDirections& random, int count, double axis)
{
  std::vector<dvec2> points(count);
  dvec2 centroid(0.0);
  for (dvec2& point : points)
  {
    const double radius = std::sqrt(random.Uniform());
    const double angle = random.Uniform(0.0, TwoPi);
    point = dvec2(axis * radius * std::cos(angle), radius * std::sin(angle));
    centroid += point / double(count);
  }
  double tt = 0.0;
  double tp = 0.0;
  double pp = 0.0;
  for (const dvec2& point : points)
  {
    const dvec2 p = point - centroid;
    const double weight = std::max(1.0 - glm::dot(p, p), 0.0);
    tt += weight * p.x * p.x;
    tp += weight * p.x * p.y;
    pp += weight * p.y * p.y;
  }
  return dvec2(tt - pp, 2.0 * tp) / (tt + pp);
}

struct MeanStrength
{
  double Raw = 0.0;
  double Shrunk = 0.0;
};

MeanStrength Measure(int count, double axis)
{
  RandomDirections random(9);
  const int disks = 400000 / count + 200; // the error of the mean is below 3 % of the noise
  MeanStrength mean;
  for (int i = 0; i < disks; ++i)
  {
    const dvec2 anisotropy = Estimate(random, count, axis);
    mean.Raw += glm::length(anisotropy) / disks;
    mean.Shrunk += glm::length(optics::WithoutSamplingNoise(anisotropy, count)) / disks;
  }
  std::cout << count << " points, half axis " << axis << ": mean strength " << mean.Raw << ", without noise "
            << mean.Shrunk << std::endl;
  return mean;
}
}

int TestSamplingNoise(int, char*[])
{
  Check check;
  const double truth = Measure(4000, 0.5).Raw;
  for (int count : { 20, 50, 200 })
  {
    const MeanStrength disk = Measure(count, 1.0);
    // theory for many points: sqrt(pi/4 * 1.2) = .97 with this weight; few points are about a centroid of
    // their own: within 10 %
    check.Near("strength of noise", disk.Raw * std::sqrt(count), 1.0, 0.1);
    check.AtMost("noise left", disk.Shrunk, 0.5 * disk.Raw);
    const MeanStrength ellipse = Measure(count, 0.5);
    // what is there is shrunk, too (.34 for .44 with 20 points), by at most half of the noise's strength
    check.Near("ellipse", ellipse.Shrunk, truth, 0.5 / std::sqrt(count));
  }
  check.Near("isotropic", glm::length(optics::WithoutSamplingNoise(dvec2(0.0, 0.0), 20.0)), 0.0, 0.0);
  check.Near("no samples", glm::length(optics::WithoutSamplingNoise(dvec2(0.3, 0.4), 0.0)), 0.0, 0.0);
  check.Near("formula", optics::WithoutSamplingNoise(dvec2(0.5, 0.0), 20.0).x, 0.375, Rounding);
  check.Near("many samples", optics::WithoutSamplingNoise(dvec2(0.3, -0.4), 1e30).y, -0.4, Rounding);
  // continuous where it reaches 0
  check.Near("threshold", optics::WithoutSamplingNoise(dvec2(0.25 + 1e-9, 0.0), 20.0).x, 0.0, 1e-8);
  return check.ExitCode();
}
