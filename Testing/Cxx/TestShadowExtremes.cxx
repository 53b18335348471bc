// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows at the ends of their ranges, where closed forms tell what is left of the light: homogeneous volumes, opaque
// from their first slice and transparent, thousands of slices, long and flat ones, a voxel thick, lights at odd places.

#include "ShadowScene.h"

#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"

namespace
{
// A homogeneous cube, seen and lit from above.
struct FogScene : ShadowScene
{
  // of this optical depth from top to bottom
  explicit FogScene(double depth)
  {
    this->MakeFog(5, 1.0, depth);
    this->Window->SetSize(9, 9);
    this->Mapper->SetSampleDistance(0.005F);
    this->Color->RemoveAllPoints();
    this->Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.2);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetPosition(0.0, 0.0, 5.0);
    this->Renderer->ResetCameraClippingRange();
    this->Optics->SetVisibilityGridSize(32);
  }

  // of so many points from bottom to top, and so wide
  void MakeFog(int points, double halfWidth, double depth)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(5, 5, points);
    image->SetOrigin(-halfWidth, -halfWidth, -1.0);
    image->SetSpacing(0.5 * halfWidth, 0.5 * halfWidth, 2.0 / (points - 1));
    image->AllocateScalars(VTK_FLOAT, 1);
    image->GetPointData()->GetScalars()->Fill(1.0);
    this->Mapper->SetInputData(image);
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.0, -std::expm1(-depth));
    this->Opacity->AddPoint(1.0, -std::expm1(-depth));
    this->Property->SetScalarOpacityUnitDistance(2.0);
  }

  double Middle()
  {
    const std::vector<float> pixels = this->RenderFloat();
    return pixels[4 * (9 * 4 + 4)];
  }
};

// int exp(-t) exp(-t / c) dt over the optical depth: the light comes from above at this cosine, and enters by the top.
double LitFog(double depth, double cosine)
{
  const double rate = 1.0 + 1.0 / cosine;
  return -std::expm1(-depth * rate) / rate;
}

void CheckDepths(Check& check)
{
  // an opaque one is lit at its first samples alone; of a step of VTK's table of 8 bits' worth less
  for (const double depth : { 1.0e-6, 0.1, 1.0, 10.0, 100.0 })
  {
    FogScene scene(depth);
    scene.AddSun(0.0, 0.0, 1.0);
    const double expected = LitFog(depth, 1.0);
    check.Near("optical depth " + std::to_string(depth), scene.Middle(), expected, 0.01 + 0.01 * expected);
  }
  FogScene transparent(0.0);
  transparent.AddSun(0.0, 0.0, 1.0);
  check.Near("nothing at all", transparent.Middle(), 0.0, 0.0);
  FogScene opaque(1.0);
  opaque.Opacity->RemoveAllPoints();
  opaque.Opacity->AddPoint(0.0, 1.0);
  opaque.AddSun(0.0, 0.0, 1.0);
  const double lit = opaque.Middle();
  check.That(lit > 0.3 && lit <= 1.0, "opaque to its first slice: " + std::to_string(lit));
}

// Neither drift nor bands: along the way down the light falls as it should, in each of some heights.
void CheckSlices(Check& check)
{
  for (const int bits : { 16, 32 })
  {
    FogScene scene(2.0);
    scene.MakeFog(5, 0.1, 2.0);
    scene.AddSun(0.0, 0.0, 1.0);
    scene.Optics->SetVisibilityGridSize(24);
    scene.Optics->SetVisibilitySliceDistance(0.1); // of the 22 froxels across: 2200 slices
    scene.Optics->SetVisibilityPrecision(bits);
    check.Near("2200 slices from above", scene.Middle(), LitFog(2.0, 1.0), 0.005);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -5.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelScale(1.0);
    scene.Window->SetSize(9, 45);
    camera->SetClippingRange(4.95, 5.05); // the middle: at its sides the volume's light is that of beside it
    const std::vector<float> side = scene.RenderFloat();
    for (int row = 1; row < 44; ++row)
    {
      const double height = 2.0 * (row + 0.5) / 45.0 - 1.0;
      const double expected = -std::expm1(-0.1) * std::exp(-(1.0 - height));
      check.Near("2200 slices, at height " + std::to_string(height), side[4 * (9 * row + 4)], expected,
        0.03 * expected);
    }
  }
}

// Stretched a hundred times as long as wide, lit along and across.
void CheckShapes(Check& check)
{
  for (const int axis : { 0, 1, 2 })
  {
    FogScene scene(2.0);
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, i, i == axis ? 10.0 : 0.1);
    }
    scene.Volume->SetUserMatrix(matrix);
    scene.Renderer->GetActiveCamera()->SetParallelScale(0.02);
    scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 50.0);
    scene.Renderer->ResetCameraClippingRange();
    scene.AddSun(0.0, 0.0, 1.0);
    // VTK measures ways before the volume's matrix
    check.Near("1:100 along " + std::to_string(axis), scene.Middle(), LitFog(2.0, 1.0), 0.02);
  }
  FogScene slab(1.0);
  slab.MakeFog(2, 1.0, 1.0);
  slab.AddSun(0.0, 0.0, 1.0);
  check.Near("one voxel thick", slab.Middle(), LitFog(1.0, 1.0), 0.01);
}

// Right at a corner, in the middle, at the camera, very far away, and looking nowhere.
void CheckPlaces(Check& check)
{
  double places[][3] = { { 1.0, 1.0, 1.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 5.0 }, { 0.0, 0.0, 1.0e7 } };
  FogScene scene(1.0);
  vtkLight* lamp = scene.AddLamp(0.0, 0.0, 1.0);
  for (const double angle : { 0.0, 80.0 })
  {
    scene.Property->SetShadowAngle(angle);
    for (auto& place : places)
    {
      lamp->SetPosition(place);
      const double lit = scene.Middle();
      const std::string name = "lamp at " + std::to_string(place[0]) + ", " + std::to_string(place[2]) +
        ", angle " + std::to_string(angle);
      check.That(lit > 0.01 && lit <= 1.0 - std::exp(-1.0) + 0.001, name + ": " + std::to_string(lit));
    }
  }
  scene.Property->SetShadowAngle(0.0);
  for (const double distance : { 10.0, 1.0e3, 3.0e3, 1.0e4, 1.0e7 })
  {
    lamp->SetPosition(0.0, 0.0, distance);
    check.Near("a lamp at " + std::to_string(distance), scene.Middle(), LitFog(1.0, 1.0), 0.01);
  }
}

// Beyond its range the angle is clamped, and said once.
void CheckAngles(Check& check)
{
  FogScene scene(1.0);
  scene.AddSun(0.0, 0.0, 1.0);
  double before = 1.0;
  for (const double angle : { 0.0, 1.0e-6, 30.0, 79.999, 80.0 })
  {
    scene.Property->SetShadowAngle(angle);
    const double lit = scene.Middle();
    check.AtMost("a wider light at " + std::to_string(angle), lit, before + 0.005);
    before = lit;
  }
  const Warnings warnings(scene.Property);
  scene.Property->SetShadowAngle(170.0);
  check.Near("an angle beyond the range", scene.Middle(), before, 0.0);
  check.Near("messages", static_cast<double>(warnings.Texts.size()), 1.0, 0.0);
}
}

int TestShadowExtremes(int, char*[])
{
  Check check;
  CheckDepths(check);
  CheckSlices(check);
  CheckShapes(check);
  CheckPlaces(check);
  CheckAngles(check);
  return check.ExitCode();
}
