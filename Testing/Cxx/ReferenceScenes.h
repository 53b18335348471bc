// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes for the tests of the reference renderer.

#ifndef ReferenceScenes_h
#define ReferenceScenes_h

#include "Check.h"
#include "RayCaster.h"

#include "vtkNew.h"

#include <memory>
#include <string>

namespace
{
namespace scenes
{
using reference::Vector;

class ConstantField : public reference::Field
{
public:
  double Value(const Vector&) const override { return 0.5; }
  Vector Gradient(const Vector&) const override { return Vector(0.0); }
};

// [-1, 1]^3 with this many voxels along each axis.
inline reference::Grid Cube(int cells = 64)
{
  reference::Grid grid;
  grid.corner = Vector(-1.0);
  grid.spacing = { 2.0 / cells, 2.0 / cells, 2.0 / cells };
  grid.points = { cells + 1, cells + 1, cells + 1 };
  return grid;
}

// Parallel, down the z axis; sees [-1, 1]^2.
inline reference::Camera ParallelCamera(int size)
{
  reference::Camera camera;
  camera.deviceToDataset = glm::dmat4(1.0);
  camera.deviceToDataset[2][2] = -3.0;
  camera.eye = Vector(0.0, 0.0, 10.0);
  camera.width = size;
  camera.height = size;
  return camera;
}

inline reference::Scene MakeScene(const std::shared_ptr<const reference::Field>& field, int size)
{
  reference::Scene scene;
  scene.field = field;
  scene.frames = std::make_shared<reference::ExactFrameField>(field);
  scene.grid = Cube();
  scene.camera = ParallelCamera(size);
  scene.lights.resize(1);
  scene.opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  scene.color = vtkSmartPointer<vtkColorTransferFunction>::New();
  scene.color->AddRGBPoint(0.0, 0.2, 0.5, 0.8);
  scene.step = 1.0 / 64.0;
  scene.terminatesEarly = false;
  scene.firstSample = 0.5;
  return scene;
}

// Transparent below one half, then nearly opaque: the surface of the quadrics.
inline void ShowSurface(reference::Scene& scene)
{
  scene.opacity->RemoveAllPoints();
  scene.opacity->AddPoint(0.45, 0.0);
  scene.opacity->AddPoint(0.55, 0.99);
  scene.unitDistance = 0.05;
}
}
}

#endif
