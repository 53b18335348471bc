// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Directions for tests of the optics: evenly spread, random, along an axis.

#ifndef Directions_h
#define Directions_h

#include <glm/glm.hpp>

#include <cmath>
#include <random>

namespace
{
constexpr double TwoPi = 6.283185307179586;

class RandomDirections
{
public:
  explicit RandomDirections(unsigned seed)
    : Engine(seed)
  {
  }

  double Uniform(double from = 0.0, double to = 1.0)
  {
    // not std::uniform_real_distribution: its numbers differ between libraries
    return from + (to - from) * (this->Engine() / 4294967296.0);
  }

  double Normal()
  {
    return std::sqrt(-2.0 * std::log(1.0 - this->Uniform())) * std::cos(TwoPi * this->Uniform());
  }

  glm::dvec3 OnSphere()
  {
    const double z = this->Uniform(-1.0, 1.0);
    const double azimuth = this->Uniform(0.0, TwoPi);
    const double rho = std::sqrt(1.0 - z * z);
    return glm::dvec3(rho * std::cos(azimuth), rho * std::sin(azimuth), z);
  }

  // Above the plane across `normal`, cosine in (least, 1).
  glm::dvec3 Above(const glm::dvec3& normal, double least = 0.0)
  {
    glm::dvec3 direction = this->OnSphere();
    while (std::abs(glm::dot(direction, normal)) <= least)
    {
      direction = this->OnSphere();
    }
    return glm::dot(direction, normal) < 0.0 ? -direction : direction;
  }

  glm::dvec3 Across(const glm::dvec3& normal)
  {
    return glm::normalize(glm::cross(normal, this->Above(normal)));
  }

private:
  std::mt19937 Engine;
};

// At the polar angle from +z.
inline glm::dvec3 Direction(double polar, double azimuth)
{
  return glm::dvec3(
    std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
}
}

#endif
