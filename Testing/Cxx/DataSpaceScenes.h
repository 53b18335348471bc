// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fields and scenes for the tests of the reference's integral in data space.

#ifndef DataSpaceScenes_h
#define DataSpaceScenes_h

#include "ReferenceScenes.h"

#include <cmath>

namespace
{
namespace scenes
{
// One half in the plane z = 0, and up along z with a slope of 10^(decades x).
class SlopesField : public reference::Field
{
public:
  explicit SlopesField(double decades)
    : Decades(decades)
  {
  }
  double Value(const Vector& p) const override { return 0.5 + p.z * std::pow(10.0, this->Decades * p.x); }
  Vector Gradient(const Vector& p) const override
  {
    const double slope = std::pow(10.0, this->Decades * p.x);
    return Vector(p.z * slope * std::log(10.0) * this->Decades, 0.0, slope);
  }

private:
  double Decades;
};

// A field at another scale of the world.
class ScaledField : public reference::Field
{
public:
  ScaledField(std::shared_ptr<const reference::Field> field, double scale)
    : Original(std::move(field))
    , Scale(scale)
  {
  }
  double Value(const Vector& p) const override { return this->Original->Value(p / this->Scale); }
  Vector Gradient(const Vector& p) const override
  {
    return this->Original->Gradient(p / this->Scale) / this->Scale;
  }

private:
  std::shared_ptr<const reference::Field> Original;
  double Scale;
};

// The same scene, larger. What VTK takes per length stays as it is.
inline reference::Scene Scaled(reference::Scene scene, double scale)
{
  scene.field = std::make_shared<ScaledField>(scene.field, scale);
  scene.frames = std::make_shared<reference::ExactFrameField>(scene.field);
  scene.grid.corner *= scale;
  for (double& spacing : scene.grid.spacing)
  {
    spacing *= scale;
  }
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      scene.camera.deviceToDataset[column][row] *= scale;
    }
  }
  scene.camera.eye *= scale;
  scene.step *= scale;
  return scene;
}

// Without a transfer function that is seen.
inline reference::Scene MakeDataScene(const std::shared_ptr<const reference::Field>& field)
{
  reference::Scene scene = MakeScene(field, 64);
  scene.integrationSpace = reference::IntegrationSpace::Data;
  scene.classification = reference::Classification::PreIntegrated;
  scene.opacity->AddPoint(0.0, 0.0);
  scene.unitInterval = 1.0;
  scene.step = 1.0 / 32.0;
  return scene;
}

// A triangle of opacity that is `opacity` as a whole.
inline void AddPeak(reference::Scene& scene, double middle, double halfWidth, double opacity)
{
  const double top = 0.9;
  scene.opacity->RemoveAllPoints();
  scene.opacity->AddPoint(middle - halfWidth, 0.0);
  scene.opacity->AddPoint(middle, top);
  scene.opacity->AddPoint(middle + halfWidth, 0.0);
  const double depth = 2.0 * halfWidth * ((1.0 - top) * std::log(1.0 - top) + top) / top;
  scene.unitInterval = depth / -std::log1p(-opacity);
}

// Of the ray parallel to z through (x, y), relative to the volume's half width.
inline glm::dvec4 PixelAt(const reference::Scene& scene, double x, double y)
{
  const double width = scene.camera.width;
  return reference::IntegrateRay(
    scene, reference::RayThrough(scene, (x + 1.0) / 2.0 * width, (y + 1.0) / 2.0 * width));
}
}
}

#endif
