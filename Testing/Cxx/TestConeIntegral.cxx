// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The cone integral by rays against closed forms.

#include "ConeIntegral.h"
#include "OcclusionScenes.h"

#include "Optics.h"

#include <array>

namespace
{
using namespace reference;
const Vector Up(0.0, 0.0, 1.0);
constexpr int Rays = 4096;

// Two seeds, to know the rays' own noise: 4096 of them in shares are off by 2e-3 at a sharp border.
constexpr double Noise = 3.0e-3;

double ConeSolidAngle(double angle)
{
  return 2.0 * optics::Pi * (1.0 - std::cos(angle));
}

// Below the top of a homogeneous block, far from its sides: the mean over the cosines of exp(-depth/cosine).
void CheckSlab(Check& check)
{
  const Scene scene = scenes::OcclusionScene([](const Vector&) { return 1.0; }, 2.0);
  const Occluders occluders(scene, 0.01);
  const double height = 0.2;
  for (double angle : { 0.0, 1e-3, 30.0, 60.0, 75.0 })
  {
    const double coneCosine = std::cos(glm::radians(angle));
    double expected = 0.0;
    const int pieces = 20000;
    for (int i = 0; i < pieces; ++i)
    {
      const double cosine = 1.0 - (i + 0.5) / pieces * (1.0 - coneCosine);
      expected += std::exp(-2.0 * height / cosine) / pieces;
    }
    const double value = ConeVisibility(occluders, Vector(0.0, 0.0, 1.0 - height), Up, { angle, Rays, 1 });
    check.Near("slab, " + std::to_string(angle), value, expected, 1.0e-4);
  }
}

// An opaque ball at a distance covers a disc of directions: of a cone, and of the whole sphere.
void CheckBall(Check& check)
{
  const Vector center(0.0, 0.0, 0.4);
  const Scene scene = scenes::OcclusionScene(
    [center](const Vector& p) { return glm::length(p - center) < 0.3 ? 1.0 : 0.0; }, 1.0e5);
  const Occluders occluders(scene, 0.004);
  const Vector point(0.0, 0.0, -0.2);
  const double covered = std::asin(0.3 / 0.6);
  for (double angle : { 30.0, 45.0, 60.0, 80.0, 180.0 })
  {
    const double expected = 1.0 - ConeSolidAngle(covered) / ConeSolidAngle(glm::radians(angle));
    // of the ball a ray may miss a chord of a step
    check.Near("ball, " + std::to_string(angle), ConeVisibility(occluders, point, Up, { angle, Rays, 1 }),
      std::max(expected, 0.0), Noise + 2.0e-3);
  }
  check.Near("away from the ball", ConeVisibility(occluders, point, -Up, { 60.0, 64, 1 }), 1.0, 0.0);
  check.Near("no cone, at it", ConeVisibility(occluders, point, Up, { 0.0, 8, 1 }), 0.0, 1e-12);
}

// On the face of an opaque half space half of the cone is left, whatever its angle and axis along the face.
void CheckHalfSpace(Check& check)
{
  const Scene scene = scenes::OcclusionScene([](const Vector& p) { return p.x > 0.0 ? 1.0 : 0.0; }, 1.0e6);
  const Occluders occluders(scene, 0.02);
  for (double angle : { 10.0, 60.0, 80.0, 180.0 })
  {
    for (const Vector& axis : { Up, glm::normalize(Vector(0.0, 1.0, -0.5)) })
    {
      const double value = ConeVisibility(occluders, Vector(0.0), axis, { angle, Rays, 1 });
      check.Near("half space, " + std::to_string(angle), value, 0.5, Noise);
    }
  }
}

void CheckRays(Check& check)
{
  const Vector axis = glm::normalize(Vector(0.3, -0.5, 0.8));
  Vector mean(0.0);
  for (const Vector& direction : ConeDirections(axis, { 60.0, Rays, 1 }, 1))
  {
    check.Near("unit", glm::length(direction), 1.0, Rounding);
    check.AtLeast("in the cone", glm::dot(direction, axis), 0.5 - Rounding);
    mean += direction / double(Rays);
  }
  check.Near("mean direction", glm::length(mean - 0.75 * axis), 0.0, 1.0e-3);
  const ConeRays few = { 60.0, 8, 2 };
  const auto first = ConeDirections(axis, few, 9), again = ConeDirections(axis, few, 9);
  const auto other = ConeDirections(axis, few, 10);
  check.That(first == again, "the same number gives the same directions");
  check.That(first != other, "another number gives others");
}

// The picture's samples carry all of its opacity, and a scene may be lit by what they see.
void CheckPicture(Check& check)
{
  Scene scene = scenes::OcclusionScene(scenes::Pit, 60.0);
  scene.color->RemoveAllPoints();
  scene.color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  scene.camera.width = scene.camera.height = 16;
  const std::vector<ShownPoint> points = ShownPoints(scene, 0.0);
  const Occluders occluders(scene, 1.0 / 32.0);
  const ConeRays rays = { 60.0, 16, 1 };
  const std::vector<double> means = MeanOfPixels(points, VisibilityAt(occluders, points, rays), 256);
  scene.visibility = [&](const Vector& point, const Vector& toViewer) {
    return ConeVisibility(occluders, point, toViewer, rays);
  };
  double most = 0.0, least = 1.0;
  for (int i = 0; i < 256; ++i)
  {
    const int column = i % 16;
    const int row = i / 16;
    const glm::dvec4 pixel = IntegrateRay(scene, RayThrough(scene, column + 0.5, row + 0.5));
    check.Near("pixel " + std::to_string(i), pixel.a > 0.0 ? pixel.r / pixel.a : -1.0, means[i], 1e-9);
    most = std::max(most, means[i]);
    least = std::min(least, means[i]);
  }
  // what is seen of a flat ground lies in its own upper layer, where about half of the light arrives
  check.AtLeast("outside of the pit", most, 0.4);
  check.AtMost("in the pit", least / most, 0.5);
}
}

int TestConeIntegral(int, char*[])
{
  Check check;
  CheckRays(check);
  CheckSlab(check);
  CheckBall(check);
  CheckHalfSpace(check);
  CheckPicture(check);
  return check.ExitCode();
}
