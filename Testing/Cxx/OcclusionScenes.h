// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Things that stand in the way, for tests of visibility: seen from +z, in [-1, 1]^3.

#ifndef OcclusionScenes_h
#define OcclusionScenes_h

#include "Directions.h"
#include "ReferenceScenes.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace
{
namespace scenes
{
// Density from 0 to 1 by a function of the place.
class FunctionField : public reference::Field
{
public:
  explicit FunctionField(std::function<double(const Vector&)> density)
    : Density(std::move(density))
  {
  }
  double Value(const Vector& p) const override { return this->Density(p); }
  Vector Gradient(const Vector&) const override { return Vector(0.0); }

private:
  std::function<double(const Vector&)> Density;
};

// The extinction is the density times `largest`, per unit of length.
inline reference::Scene OcclusionScene(std::function<double(const Vector&)> density, double largest)
{
  auto field = std::make_shared<FunctionField>(std::move(density));
  reference::Scene scene = MakeScene(field, 32);
  // optical depths 0 to 1 in 64 pieces: their curve is a chord's width off, 3e-5
  for (int i = 0; i <= 64; ++i)
  {
    scene.opacity->AddPoint(i / 64.0, 1.0 - std::exp(-i / 64.0));
  }
  scene.unitDistance = 1.0 / largest;
  return scene;
}

// From 0 below -width/2 to 1 above width/2.
inline double SoftStep(double x, double width)
{
  const double t = glm::clamp(x / width + 0.5, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

constexpr double Softness = 0.06; // two of 64 voxels

// A roof over one half of a floor.
inline double Edge(const Vector& p)
{
  const double roof =
    SoftStep(-p.x, Softness) * SoftStep(p.z - 0.1, Softness) * SoftStep(0.3 - p.z, Softness);
  return std::max(roof, SoftStep(-0.6 - p.z, Softness));
}

// A round hole in a floor.
inline double Pit(const Vector& p)
{
  const double ground = SoftStep(0.3 - p.z, Softness);
  const double hole = SoftStep(0.35 - std::hypot(p.x, p.y), Softness) * SoftStep(p.z + 0.6, Softness);
  return ground * (1.0 - hole);
}

struct Blobs
{
  Blobs()
  {
    RandomDirections random(3);
    for (int i = 0; i < 24; ++i)
    {
      this->Centers.emplace_back(
        random.Uniform(-0.8, 0.8), random.Uniform(-0.8, 0.8), random.Uniform(-0.8, 0.8));
    }
  }
  double operator()(const Vector& p) const
  {
    double most = 0.0;
    for (const Vector& center : this->Centers)
    {
      most = std::max(most, SoftStep(0.18 - glm::length(p - center), Softness));
    }
    return most;
  }
  std::vector<Vector> Centers;
};

struct Fibres
{
  Fibres()
  {
    RandomDirections random(4);
    for (int i = 0; i < 40; ++i)
    {
      this->Lines.emplace_back(
        Vector(random.Uniform(-0.9, 0.9), random.Uniform(-0.9, 0.9), random.Uniform(-0.9, 0.9)),
        random.OnSphere());
    }
  }
  double operator()(const Vector& p) const
  {
    double most = 0.0;
    for (const auto& [point, direction] : this->Lines)
    {
      most = std::max(most, SoftStep(0.05 - glm::length(glm::cross(p - point, direction)), Softness));
    }
    return most;
  }
  std::vector<std::pair<Vector, Vector>> Lines;
};
}
}

#endif
