// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The reference renderer's shadows of lights against closed forms.

#include "LightShadow.h"
#include "OcclusionScenes.h"

#include <string>

using namespace reference;

namespace
{
constexpr double Step = 0.004;
const Vector Ball(0.0, 0.0, 0.4);
constexpr double Radius = 0.3;

Scene Block(double extinction)
{
  return scenes::OcclusionScene([](const Vector&) { return 1.0; }, extinction);
}

// Opaque, at half of the way from the middle to the top.
Scene OpaqueBall()
{
  return scenes::OcclusionScene(
    [](const Vector& p) { return glm::length(p - Ball) < Radius ? 1.0 : 0.0; }, 1.0e5);
}

Light LightAt(const Vector& position)
{
  Light light;
  light.positional = true;
  light.position = position;
  return light;
}

// The way out of the block, or to a light in it.
void CheckBlock(Check& check)
{
  const Scene scene = Block(1.5);
  const LightShadow shadow(scene, 0.0, Step);
  const Vector point(0.25, -0.5, 0.125);
  Light sun;
  sun.toLight = glm::normalize(Vector(1.0, 0.0, 1.0));
  check.Near("sun", shadow(sun, point), std::exp(-1.5 * 0.75 * std::sqrt(2.0)), 1.0e-4);
  const Vector inside(0.5, 0.25, -0.125);
  check.Near(
    "lamp inside", shadow(LightAt(inside), point), std::exp(-1.5 * glm::length(inside - point)), 1.0e-4);
  check.Near("lamp outside", shadow(LightAt({ 0.25, -0.5, 9.0 }), point), std::exp(-1.5 * 0.875), 1.0e-4);
  check.Near("lamp at the point", shadow(LightAt(point), point), 1.0, 0.0);
  sun.shadowAttenuation = 0.25;
  check.Near("a quarter of a shadow", shadow(sun, point),
    1.0 - 0.25 * (1.0 - std::exp(-1.5 * 0.75 * std::sqrt(2.0))), 1.0e-4);
}

// Between light and ball, behind the ball, beside it.
void CheckBall(Check& check)
{
  const Scene scene = OpaqueBall();
  const LightShadow shadow(scene, 0.0, Step);
  Light sun;
  sun.toLight = Vector(0.0, 0.0, 1.0);
  const Light lamp = LightAt({ 0.0, 0.0, 2.0 });
  for (const Light& light : { sun, lamp })
  {
    check.Near("in front of the ball", shadow(light, { 0.0, 0.0, 0.9 }), 1.0, 0.0);
    check.Near("behind the ball", shadow(light, { 0.0, 0.0, -0.5 }), 0.0, 1.0e-12);
  }
  // the lamp's shadow grows: its border is at a sine of Radius/1.6 from the axis
  const double border = 2.5 * std::tan(std::asin(Radius / 1.6));
  check.Near("sun, beside the ball", shadow(sun, { Radius + 0.01, 0.0, -0.5 }), 1.0, 0.0);
  check.Near("lamp, in the border", shadow(lamp, { border - 0.01, 0.0, -0.5 }), 0.0, 1.0e-12);
  check.Near("lamp, beside the ball", shadow(lamp, { border + 0.01, 0.0, -0.5 }), 1.0, 0.0);
}

// The ball covers a part of the light's disk, of the same angle from the middle.
void CheckSoft(Check& check)
{
  const Scene scene = OpaqueBall();
  const Vector middle(0.0);
  const double covered = 1.0 - std::cos(std::asin(Radius / Ball.z));
  Light sun;
  sun.toLight = Vector(0.0, 0.0, 1.0);
  for (const double angle : { 20.0, 60.0, 75.0 })
  {
    const LightShadow shadow(scene, angle, Step, 4096);
    const double expected = std::max(1.0 - covered / (1.0 - std::cos(glm::radians(angle))), 0.0);
    // rays in shares: see TestConeIntegral
    check.Near("soft sun, " + std::to_string(angle), shadow(sun, middle), expected, 5.0e-3);
    check.Near(
      "soft lamp, " + std::to_string(angle), shadow(LightAt({ 0.0, 0.0, 5.0 }), middle), expected, 5.0e-3);
  }
  // a lamp in the middle of the volume is a point
  const LightShadow wide(scene, 80.0, Step);
  check.Near("lamp in the middle", wide(LightAt(middle), { 0.0, 0.0, -0.9 }), 1.0, 0.0);
}

// Radiance of a sample in the shadow: ambient light alone.
void CheckPicture(Check& check)
{
  Scene scene = OpaqueBall();
  scene.shade = true;
  scene.ambient = 0.25;
  scene.diffuse = 0.5;
  scene.reflectance = Reflectance::None;
  scene.lights[0].toLight = Vector(0.0, 0.0, -1.0);
  const Vector color = scene.Color(1.0);
  const glm::dvec4 lit = IntegrateRay(scene, RayThrough(scene, 16.0, 16.0));
  scene.shadow = LightShadow(scene, 0.0, Step);
  const glm::dvec4 shadowed = IntegrateRay(scene, RayThrough(scene, 16.0, 16.0));
  check.Near("lit", lit.r, 0.75 * color.r, 1.0e-6);
  check.Near("on the far side from the light", shadowed.r, 0.25 * color.r, 1.0e-6);
}
}

int TestLightShadow(int, char*[])
{
  Check check;
  CheckBlock(check);
  CheckBall(check);
  CheckSoft(check);
  CheckPicture(check);
  return check.ExitCode();
}
