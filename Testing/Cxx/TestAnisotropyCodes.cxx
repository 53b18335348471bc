// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Map, Components, World: what goes in comes out; which of them is continuous, and what a flip of the
// normal does to each.

#include "Check.h"
#include "Directions.h"
#include "Optics.h"

namespace
{
using glm::dvec2;
using glm::dvec3;

// Of the covariance l2 along `major` and l1 across, in the plane of the normal: (a1, a2).
dvec2 AnisotropyAlong(const dvec3& normal, const dvec3& major, double strength)
{
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  const double angle = std::atan2(glm::dot(major, basis.phi), glm::dot(major, basis.theta));
  return strength * dvec2(std::cos(2.0 * angle), std::sin(2.0 * angle));
}

double Distance(const optics::WorldTensor& a, const optics::WorldTensor& b)
{
  return glm::distance(a.diagonal, b.diagonal) + glm::distance(a.mixed, b.mixed);
}

void CheckRoundTrips(Check& check, const dvec3& normal, const dvec2& anisotropy)
{
  // 1e-15 of a basis at the threshold of the pole and a dozen roundings
  const double roundings = 4e-15;
  const dvec3 map = optics::EncodeMap(normal, anisotropy);
  check.Near("map", glm::distance(optics::DecodeMap(normal, map), anisotropy), 0.0, roundings);
  check.AtMost("map within [-1, 1]", std::max(std::abs(map.x), std::max(std::abs(map.y), std::abs(map.z))),
    1.0 + roundings);
  const dvec3 components = optics::EncodeComponents(anisotropy);
  check.Near("components", glm::distance(optics::DecodeComponents(components), anisotropy), 0.0, roundings);
  check.Near("trace", components.x + components.z, 1.0, roundings);
  const optics::WorldTensor world = optics::EncodeWorld(normal, anisotropy);
  check.Near("world", glm::distance(optics::DecodeWorld(normal, world), anisotropy), 0.0, roundings);
  check.Near("world across the plane", glm::length(optics::TimesVector(world, normal)), 0.0, roundings);
}

// The same directions in space, seen with the normal turned round.
void CheckFlip(Check& check, const dvec3& normal, const dvec2& anisotropy)
{
  const double roundings = 4e-15;
  const dvec2 flipped(anisotropy.x, -anisotropy.y); // phi turns round, theta stays
  check.Near("world is free of the sign",
    Distance(optics::EncodeWorld(normal, anisotropy), optics::EncodeWorld(-normal, flipped)), 0.0, roundings);
  const dvec3 map = optics::EncodeMap(normal, anisotropy);
  check.Near("map turns two signs",
    glm::distance(optics::EncodeMap(-normal, flipped), dvec3(-map.x, -map.y, map.z)), 0.0, roundings);
  const optics::AnisotropyFrame a = optics::EigenFrame(normal, anisotropy);
  const optics::AnisotropyFrame b = optics::EigenFrame(-normal, flipped);
  check.Near("the line of U", std::abs(glm::dot(a.major, b.major)), 1.0, roundings);
}

// Two normals at a distance across the pole, the same line in space.
void CheckPole(Check& check, double pole)
{
  RandomDirections random(5);
  double worstMap = 0.0;
  double worstWorld = 0.0;
  double meanComponents = 0.0;
  const int pairs = 10000;
  for (int i = 0; i < pairs; ++i)
  {
    const double radius = std::pow(10.0, random.Uniform(-12.0, -1.0));
    const auto nearPole = [&] {
      const double azimuth = random.Uniform(0.0, TwoPi);
      return dvec3(
        radius * std::cos(azimuth), radius * std::sin(azimuth), pole * std::sqrt(1.0 - radius * radius));
    };
    const dvec3 n1 = nearPole();
    const dvec3 n2 = nearPole();
    const dvec3 line = random.Across(dvec3(0.0, 0.0, 1.0));
    const dvec2 a1 = AnisotropyAlong(n1, line, 0.8);
    const dvec2 a2 = AnisotropyAlong(n2, line, 0.8);
    worstMap =
      std::max(worstMap, glm::distance(optics::EncodeMap(n1, a1), optics::EncodeMap(n2, a2)) / radius);
    worstWorld =
      std::max(worstWorld, Distance(optics::EncodeWorld(n1, a1), optics::EncodeWorld(n2, a2)) / radius);
    meanComponents += glm::distance(optics::EncodeComponents(a1), optics::EncodeComponents(a2)) / pairs;
  }
  std::cout << "across the pole, per distance: map " << worstMap << ", world " << worstWorld
            << "; components jump by " << meanComponents << " at any distance" << std::endl;
  // |w^2|' = 2|w| and a plane that tilts by the distance: a small factor, however near the pole;
  // the roundings (1e-16/1e-12) don't count
  check.AtMost("map is Lipschitz", worstMap, 4.0);
  check.AtMost("world is Lipschitz", worstWorld, 4.0);
  // strength .8 times the mean of a chord between two random double angles, 4/pi, over sqrt 2
  check.AtLeast("components jump", meanComponents, 0.5);
}
}

int TestAnisotropyCodes(int, char*[])
{
  Check check;
  RandomDirections random(6);
  for (int i = 0; i < 20000; ++i)
  {
    const double strength = i % 10 == 0 ? 1.0 : random.Uniform();
    const double angle = random.Uniform(0.0, TwoPi);
    const dvec2 anisotropy = strength * dvec2(std::cos(angle), std::sin(angle));
    dvec3 normal = random.OnSphere();
    CheckRoundTrips(check, normal, anisotropy);
    CheckFlip(check, normal, anisotropy);
    const double rho = std::pow(10.0, random.Uniform(-20.0, -1.0));
    normal = glm::normalize(dvec3(rho * normal.x, rho * normal.y, normal.z > 0.0 ? 1.0 : -1.0));
    CheckRoundTrips(check, normal, anisotropy);
    if (rho > 1e-14) // nearer, the azimuth is the convention's, which is not odd in n
    {
      CheckFlip(check, normal, anisotropy);
    }
  }
  for (double pole : { -1.0, 1.0 })
  {
    CheckRoundTrips(check, dvec3(0.0, 0.0, pole), dvec2(0.6, -0.8));
    CheckRoundTrips(check, dvec3(0.0, 0.0, pole), dvec2(0.0, 0.0));
    CheckPole(check, pole);
  }
  return check.ExitCode();
}
