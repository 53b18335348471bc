// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Stretches of the scalar's axis with what a transfer function puts there, and how a ray sees them.

#ifndef AttenuatedStretch_h
#define AttenuatedStretch_h

#include <glm/glm.hpp>

#include <array>

namespace volumeoptics
{
// Below, an optical depth is none: its quotients have lost their digits.
constexpr double LeastDepth = 1.0e-290;

// What a transfer function holds between two scalars. Integrals over the stretch, of attenuation tau and
// colour c; every one is a sum of positive terms, so none loses digits.
struct Stretch
{
  double width = 0.0;
  double depth = 0.0;                    // of tau
  glm::dvec3 emission = glm::dvec3(0.0); // of c tau
  glm::dvec3 color = glm::dvec3(0.0);    // of c
  glm::dvec3 first = glm::dvec3(0.0);    // c at the lower end
  glm::dvec3 last = glm::dvec3(0.0);     // c at the upper end
  glm::dvec3 least = glm::dvec3(0.0);    // bounds of c
  glm::dvec3 largest = glm::dvec3(0.0);
};

// The stretch of both; upper begins where lower ends.
Stretch Join(const Stretch& lower, const Stretch& upper);

// Functions that are linear on the stretch, by their ends: opacities in [0, 1] of the unit of tau, which is
// `attenuation` per width at an optical depth of 1.
Stretch LinearStretch(double width, double attenuation, const std::array<double, 2>& opacity,
  const glm::dvec3& first, const glm::dvec3& last);

// A stretch as a ray sees it that crosses it upwards (the scalar grows) or downwards.
struct Slab
{
  double width = 0.0;
  double depth = 0.0;
  double transparency = 1.0;
  double opacity = 0.0;
  glm::dvec3 upward = glm::dvec3(0.0); // associated colours
  glm::dvec3 downward = glm::dvec3(0.0);
  glm::dvec3 color = glm::dvec3(0.0); // integral of c
};

// With tau times `scale`. Within the stretch colour is taken as linear in the optical depth.
Slab Attenuate(const Stretch& stretch, double scale);

// Exact: the upper one is behind the lower one for the ray upwards, before it for the ray downwards.
Slab Composite(const Slab& lower, const Slab& upper);

// Non-associated colour of the ray; the plain mean where nothing attenuates.
glm::dvec3 UpwardColor(const Slab& slab);
glm::dvec3 DownwardColor(const Slab& slab);
}

#endif
