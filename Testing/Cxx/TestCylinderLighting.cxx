// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Ambient, diffuse and specular light of a cylinder against the integral over its surface, with V and L
// anywhere; visible area, and the bounds of the optical depth.

#include "Check.h"
#include "Directions.h"
#include "LineQuadrature.h"
#include "Optics.h"

#include <algorithm>
#include <string>

namespace
{
const double HalfTurn = TwoPi / 2.0;

// Half of the integral over the side that is seen and lit, [Schussman2004] eq. 4, the limits by the signs
// of n.V and n.L alone.
template <class Radiance>
double MeanOverSurface(
  const glm::dvec3& tangent, const glm::dvec3& viewer, const glm::dvec3& light, const Radiance& radiance)
{
  const optics::CylinderView view = optics::ViewOfCylinder(tangent, viewer);
  const double lit = std::atan2(glm::dot(light, view.binormal), glm::dot(light, view.normal));
  double sum = 0.0;
  // the terminator is at lit +- pi/2: integrate on either side of it, and leave the dark part out
  double edges[4] = { -HalfTurn / 2.0, lit - HalfTurn / 2.0, lit + HalfTurn / 2.0, HalfTurn / 2.0 };
  for (double& edge : edges)
  {
    edge = std::clamp(edge, -HalfTurn / 2.0, HalfTurn / 2.0);
  }
  std::sort(edges, edges + 4);
  for (int i = 0; i < 3; ++i)
  {
    const auto normalAt = [&](double t) { return view.normal * std::cos(t) + view.binormal * std::sin(t); };
    const bool isLit = glm::dot(normalAt((edges[i] + edges[i + 1]) / 2.0), light) > 0.0;
    sum += isLit
      ? Integrate([&](double t) { return radiance(normalAt(t)) * std::cos(t); }, edges[i], edges[i + 1])
      : 0.0;
  }
  return sum / 2.0;
}

void CheckLights(Check& check)
{
  RandomDirections random(7);
  for (int i = 0; i < 300; ++i)
  {
    const glm::dvec3 tangent = random.OnSphere(), viewer = random.OnSphere();
    const glm::dvec3 light = i % 10 == 0 ? viewer : random.OnSphere();
    const optics::CylinderView view = optics::ViewOfCylinder(tangent, viewer);
    check.Near("sine", view.sine, glm::length(glm::cross(tangent, viewer)), Rounding);
    const double diffuse =
      MeanOverSurface(tangent, viewer, light, [&](const glm::dvec3& n) { return glm::dot(n, light); });
    check.Near("diffuse", optics::DiffuseOfCylinder(view, light), diffuse, 100.0 * Rounding);
    const glm::dvec3 half = glm::normalize(light + viewer);
    for (double exponent : { 1.0, 2.5, 10.0, 32.0, 100.0, 1000.0 })
    {
      const double specular = MeanOverSurface(tangent, viewer, light,
        [&](const glm::dvec3& n) { return std::pow(std::max(glm::dot(n, half), 0.0), exponent); });
      // of which the integral of the cosine's power has 1e-8
      check.Near("specular, exponent " + std::to_string(exponent),
        optics::SpecularOfCylinder(view, light, viewer, exponent), specular, 1e-8);
    }
  }
}

// Headlight: pi/4 sine, and W(k + 1)/2 sine^k.
void CheckHeadlight(Check& check)
{
  for (double angle = 0.05; angle < HalfTurn; angle += 0.1)
  {
    const glm::dvec3 tangent(0.0, 0.0, 1.0), viewer = Direction(angle, 0.4);
    const optics::CylinderView view = optics::ViewOfCylinder(tangent, viewer);
    check.Near(
      "diffuse", optics::DiffuseOfCylinder(view, viewer), HalfTurn / 4.0 * std::sin(angle), Rounding);
    for (double exponent : { 1.0, 30.0, 1000.0 })
    {
      check.Near("specular", optics::SpecularOfCylinder(view, viewer, viewer, exponent),
        optics::WallisIntegral(exponent + 1.0) / 2.0 * std::pow(std::sin(angle), exponent), 1e-8);
    }
    check.Near("area", optics::VisibleArea(0.5, 3.0, view.sine), 3.0 * std::sin(angle), Rounding);
  }
}

void CheckExtremes(Check& check)
{
  const glm::dvec3 tangent(0.0, 0.6, 0.8), viewer(1.0, 0.0, 0.0);
  const glm::dvec3 lights[] = { tangent, -tangent, viewer, -viewer };
  for (const glm::dvec3& toViewer : { tangent, -tangent, viewer })
  {
    const optics::CylinderView view = optics::ViewOfCylinder(tangent, toViewer);
    check.Near("unit normal", glm::length(view.normal), 1.0, Rounding);
    for (const glm::dvec3& light : lights)
    {
      check.AtMost("diffuse", optics::DiffuseOfCylinder(view, light), HalfTurn / 4.0 + Rounding);
      for (double exponent : { 1.0, 1000.0 })
      {
        const double specular = optics::SpecularOfCylinder(view, light, toViewer, exponent);
        check.Finite("specular", specular);
        check.AtMost("specular", specular, 1.0);
      }
    }
  }
  // half vector along T: V and L mirrored at T
  const glm::dvec3 mirrored =
    2.0 * tangent * glm::dot(tangent, glm::dvec3(0.0, 0.0, 1.0)) - glm::dvec3(0.0, 0.0, 1.0);
  const optics::CylinderView view = optics::ViewOfCylinder(tangent, mirrored);
  check.Near("half vector along the tangent",
    optics::SpecularOfCylinder(view, glm::dvec3(0.0, 0.0, 1.0), mirrored, 10.0), 0.0, Rounding);
}

// Bundles of every spread: the depth is within the bounds, which the parts of degree 0 and 2 give; an
// aligned one has none end-on.
void CheckDepthBounds(Check& check)
{
  RandomDirections random(9);
  for (int bundle = 0; bundle < 200; ++bundle)
  {
    const glm::dvec3 axis = random.OnSphere(), viewer = bundle % 3 == 0 ? axis : random.OnSphere();
    const double spread = bundle % 2 == 0 ? 0.0 : random.Uniform(0.0, 2.0);
    double depth = 0.0, degree0 = 0.0, degree2 = 0.0;
    for (int i = 0; i < 20; ++i)
    {
      const glm::dvec3 tangent = glm::normalize(axis + spread * random.OnSphere());
      const double cosine = glm::dot(tangent, viewer);
      depth += std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
      degree0 += 0.5 * optics::SineMoment(0, 1.0);
      degree2 += 2.5 * optics::SineMoment(2, 1.0) * std::legendre(2, cosine);
    }
    const glm::dvec2 bounds = optics::DepthBounds(degree0, degree2);
    check.AtLeast("depth", depth, bounds.x - 1e-9);
    check.AtMost("depth", depth, bounds.y + 1e-6); // the root of a rounding
  }
  for (double q : { 1e-6, 0.03, 0.0999, 0.1, 0.3, 0.7, 0.99 })
  {
    const double mean = Integrate(
      [&](double angle) { return -std::log1p(-q * std::sin(angle)) * std::sin(angle); }, 0.0, HalfTurn / 2.0);
    // the series ends at q^6: 1e-7 at q = 0.1; the logarithm's slope near 1 is hard for the quadrature
    check.Near("mean depth of a share", optics::MeanDepthOfShare(q), mean, (q < 0.9 ? 1.1e-7 : 1e-6) * mean);
  }
  check.Near("all of a box", optics::MeanDepthOfShare(1.0), 1.0 + HalfTurn / 2.0, Rounding);
  check.Near("depth of an area", optics::DepthOfVisibleArea(0.3, 6.0), 0.2, Rounding);
}
}

int TestCylinderLighting(int, char*[])
{
  Check check;
  CheckLights(check);
  CheckHeadlight(check);
  CheckExtremes(check);
  CheckDepthBounds(check);
  return check.ExitCode();
}
