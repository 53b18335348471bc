// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Blinn-Phong, Ward and Lafortune: closed cases, reciprocity, bounds.

#include "Check.h"
#include "Directions.h"
#include "Optics.h"

namespace
{
using glm::dvec3;

const dvec3 Normal(0.0, 0.0, 1.0);
const dvec3 Major(1.0, 0.0, 0.0);
const dvec3 Minor(0.0, 1.0, 0.0);

void CheckBlinnPhong(Check& check)
{
  for (double exponent : { 0.01, 1.0, 30.0, 1e5 })
  {
    check.Near("peak", optics::BlinnPhongReflection(Normal, Normal, Normal, exponent), 1.0, 0.0);
    // half of the peak where cos^n = 1/2, for n < 1 some other level that a cosine of .5 has; the
    // exponent multiplies the rounding of the cosine
    const double level = std::max(0.5, std::pow(0.5, exponent));
    const dvec3 aside = Direction(std::acos(std::pow(level, 1.0 / exponent)), 0.7);
    const double value = optics::BlinnPhongReflection(Normal, aside, aside, exponent) / aside.z;
    check.Near("half width, exponent " + std::to_string(exponent), value, level, Rounding * (1.0 + exponent));
    check.Near("light behind", optics::BlinnPhongReflection(Normal, -Normal, Normal, exponent), 0.0, 0.0);
    check.Finite("light opposite", optics::BlinnPhongReflection(Normal, Major, -Major, exponent));
  }
  RandomDirections random(1);
  for (int i = 0; i < 1000; ++i)
  {
    const dvec3 l = random.Above(Normal);
    const dvec3 v = random.Above(Normal);
    const double there = optics::BlinnPhongReflection(Normal, l, v, 30.0) / l.z;
    const double back = optics::BlinnPhongReflection(Normal, v, l, 30.0) / v.z;
    check.Near("reciprocity", there, back, Rounding);
  }
}

// [Ward1992] without the bound: 1/sqrt(N.L N.V) times N.L.
double PublishedWard(const dvec3& l, const dvec3& v, double u, double w)
{
  const dvec3 h = glm::normalize(l + v);
  const double e = (h.x * h.x / (u * u) + h.y * h.y / (w * w)) / (h.z * h.z);
  return std::exp(-e) / (4.0 * optics::Pi * u * w * std::sqrt(l.z * v.z)) * l.z;
}

void CheckWard(Check& check)
{
  RandomDirections random(2);
  for (int i = 0; i < 10000; ++i)
  {
    const dvec3 l = random.Above(Normal);
    const dvec3 v = random.Above(Normal);
    const double u = std::exp(random.Uniform(std::log(0.01), std::log(4.0)));
    const double w = std::exp(random.Uniform(std::log(0.01), 0.0));
    const double peak = 1.0 / (4.0 * optics::Pi * u * w);
    const double there = optics::WardReflection(Normal, Major, Minor, l, v, u, w);
    const double back = optics::WardReflection(Normal, Major, Minor, v, l, u, w);
    // reciprocity of f: our cosine form is N.L/max(N.L, N.V), N.L times something symmetric
    check.Near("reciprocity", there / l.z, back / v.z, Rounding * there / l.z + 1e-300);
    check.AtMost("bound", there, peak);
    check.AtLeast("sign", there, 0.0);
    // sqrt(N.L N.V) <= max(N.L, N.V)
    check.AtMost("never above the published one", there, PublishedWard(l, v, u, w) * (1.0 + 1e-9) + 1e-300);

    // equal where N.L = N.V
    const dvec3 same = Direction(std::acos(l.z), random.Uniform(0.0, TwoPi));
    const double published = PublishedWard(l, same, u, w);
    // the exponent E, up to 1e4 before exp underflows at 745, multiplies the roundings
    check.Near("as published", optics::WardReflection(Normal, Major, Minor, l, same, u, w), published,
      1e-12 * published + 1e-300);
    // isotropic: exp(-tan^2/u^2), whatever the frame
    const dvec3 turned = random.Across(Normal);
    const double iso = optics::WardReflection(Normal, turned, glm::cross(Normal, turned), l, v, w, w);
    const double tangent = std::tan(std::acos(glm::normalize(l + v).z));
    const double closed =
      std::exp(-tangent * tangent / (w * w)) / (4.0 * optics::Pi * w * w) * l.z / std::max(l.z, v.z);
    // acos near 1 leaves 8 digits of the angle
    check.Near("isotropic", iso, closed, 1e-6 / (4.0 * optics::Pi * w * w));
  }
  check.Near("peak", optics::WardReflection(Normal, Major, Minor, Normal, Normal, 0.5, 0.25),
    2.0 / optics::Pi, Rounding);
  check.Near(
    "viewer behind", optics::WardReflection(Normal, Major, Minor, Normal, -Normal, 0.2, 0.2), 0.0, 0.0);
  check.Near(
    "light behind", optics::WardReflection(Normal, Major, Minor, -Normal, Normal, 0.2, 0.2), 0.0, 0.0);
  check.Near(
    "viewer in the plane", optics::WardReflection(Normal, Major, Minor, Normal, Major, 0.2, 0.2), 0.0, 0.0);
  for (double cosine : { 1e-3, 1e-6, 1e-12, 1e-300 })
  {
    const dvec3 grazing(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    const dvec3 mirror(-grazing.x, 0.0, cosine);
    check.Near("mirror at grazing", optics::WardReflection(Normal, Major, Minor, grazing, mirror, 1.0, 1.0),
      0.25 / optics::Pi, Rounding);
    check.Finite("retroreflection at grazing",
      optics::WardReflection(Normal, Major, Minor, grazing, grazing, 1e-4, 1e-4));
  }
}

void CheckWardRoughness(Check& check)
{
  check.Near("isotropic", optics::WardMajorRoughness(0.2, 0.0, 10.0), 0.2, Rounding);
  check.Near("no scale", optics::WardMajorRoughness(0.2, 7.0, 0.0), 0.2, Rounding);
  check.Near("ratio 2, scale 3", optics::WardMajorRoughness(0.2, std::log(2.0), 3.0), 1.6, Rounding);
  for (double roughness : { 1e-4, 0.2, 1.0 })
  {
    double last = 0.0;
    for (double scale : { 0.0, 0.1, 1.0, 10.0, 60.0, 1e4 })
    {
      const double u = optics::WardMajorRoughness(roughness, optics::LogRatio(0.9), scale);
      check.AtLeast("monotone", u, last);
      check.AtMost("bound", u, 4.0 + Rounding);
      last = u;
    }
    check.Near("bound reached", last, 4.0, Rounding * 4.0);
  }
}

void CheckLafortune(Check& check)
{
  check.Near("isotropic weight", optics::LafortuneMajorWeight(0.0, 10.0), -1.0, 0.0);
  check.Near("weight without a scale", optics::LafortuneMajorWeight(7.0, 0.0), -1.0, 0.0);
  check.Near("weight, ratio 2, scale 1", optics::LafortuneMajorWeight(std::log(2.0), 1.0),
    1.0 - 2.0 * std::exp(-1.0), Rounding);
  double last = -1.0;
  for (double scale : { 0.0, 1e-3, 0.1, 1.0, 10.0, 60.0, 1e4 })
  {
    const double weight = optics::LafortuneMajorWeight(optics::LogRatio(0.5), scale);
    check.AtLeast("monotone weight", weight, last);
    check.AtMost("weight", weight, 1.0);
    last = weight;
  }
  check.Near("weight of strong anisotropy", last, 1.0, 0.0);

  RandomDirections random(3);
  for (int i = 0; i < 10000; ++i)
  {
    const dvec3 l = random.Above(Normal);
    const dvec3 v = random.OnSphere();
    const double exponent = std::exp(random.Uniform(std::log(0.01), std::log(1e3)));
    const double phong = std::pow(std::max(glm::dot(2.0 * l.z * Normal - l, v), 0.0), exponent) * l.z;
    const double value = optics::LafortuneReflection(Normal, Major, Minor, l, v, -1.0, exponent);
    // the cosine's rounding grows by the exponent
    check.Near("Phong", value, phong, Rounding * (1.0 + exponent));
    const double weight = random.Uniform(-1.0, 1.0);
    const double there = optics::LafortuneReflection(Normal, Major, Minor, l, v, weight, exponent);
    check.AtMost("bounded by the cosine", there, l.z);
    check.AtLeast("sign", there, 0.0);
    if (v.z > 0.0)
    {
      const double back = optics::LafortuneReflection(Normal, Major, Minor, v, l, weight, exponent);
      check.Near("reciprocity", there / l.z, back / v.z, Rounding * (1.0 + exponent));
    }
  }
  check.Near(
    "light behind", optics::LafortuneReflection(Normal, Major, Minor, -Normal, Normal, -1.0, 30.0), 0.0, 0.0);
}
}

int TestReflectance(int, char*[])
{
  Check check;
  CheckBlinnPhong(check);
  CheckWard(check);
  CheckWardRoughness(check);
  CheckLafortune(check);
  return check.ExitCode();
}
