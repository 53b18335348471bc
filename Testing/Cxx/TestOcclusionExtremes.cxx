// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Occlusion at the ends of its ranges: finite, between nothing and all of the light, and where the scene is the
// same in other units or another window, the same.

#include "OcclusionTesting.h"
#include "ResizedTable.h"
#include "ScenePixels.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

namespace
{
double RoofAndFloor(double x, double, double z)
{
  return z < FloorHeight || (x < 0.0 && std::abs(z) < 0.1) ? Dense : 0.0;
}

void CheckPixels(Check& check, const std::string& name, OcclusionScene& scene)
{
  for (const float value : scene.RenderFloat())
  {
    // the sum of a ray's opacities is 1 but for its rounding
    if (!check.That(value >= 0.0F && value <= 1.0001F, name + ": " + std::to_string(value)))
    {
      return;
    }
  }
}

void CheckAngles(Check& check)
{
  OcclusionScene scene(RoofAndFloor);
  scene.Property->OcclusionOn();
  double before = 1.0;
  for (const double angle : { 0.0, 1.0e-6, 30.0, 79.999, 80.0 })
  {
    scene.Property->SetOcclusionAngle(angle);
    CheckPixels(check, "angle " + std::to_string(angle), scene);
    const double seen = scene.Red(8);
    check.AtMost("a wider cone at " + std::to_string(angle), seen, before + 0.01);
    before = seen;
  }
}

void CheckKnobs(Check& check)
{
  OcclusionScene scene(RoofAndFloor);
  scene.Property->OcclusionOn();
  const int knobs[][3] = { { 0, 8, 4 }, { 0, 16, 8 }, { 0, 32, 16 }, { 1, 16, 8 }, { 2, 32, 8 } };
  for (const auto& [algorithm, bits, samples] : knobs)
  {
    scene.Optics->SetVisibilityAlgorithm(algorithm);
    scene.Optics->SetVisibilityPrecision(bits);
    scene.Optics->SetVisibilitySamples(samples);
    CheckPixels(check, "knobs", scene);
    const double open = scene.Red(14);
    check.Near("open floor", open, OpenFloor(60.0), 0.05);
    // the disks do not keep the cone as wide as it is
    check.AtMost("beside the roof", scene.Red(2), (algorithm == 0 ? 0.8 : 0.97) * open);
  }
  scene.Optics->SetVisibilityDiskSize(1);
  CheckPixels(check, "a disk of one point", scene);
  scene.Optics->VisibilityTrueDistancesOff();
  CheckPixels(check, "approximated distances", scene);
  scene.Optics->SetVisibilityAlgorithmToDirectionSweep();
  for (const int size : { 1, 2, 7 })
  {
    scene.Optics->SetVisibilityGridSize(size);
    CheckPixels(check, "a grid of " + std::to_string(size), scene);
  }
}

// Opaque to its first slice, and all of it transparent.
void CheckOpacities(Check& check)
{
  OcclusionScene scene([](double, double, double) { return Dense; });
  scene.Property->OcclusionOn();
  for (const double opacity : { 0.0, 1.0e-7, 1.0 })
  {
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.0, opacity);
    CheckPixels(check, "opacity " + std::to_string(opacity), scene);
  }
  check.Near("an opaque volume", scene.Red(), OpenFloor(60.0), 0.01);
}

// The same picture in millionths and in millions of the unit.
void CheckScales(Check& check)
{
  std::vector<float> pictures[3];
  const double scales[3] = { 1.0, 1.0e-6, 1.0e6 };
  for (int i = 0; i < 3; ++i)
  {
    OcclusionScene scene(RoofAndFloor);
    auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
    const double scale = scales[i];
    image->SetSpacing(scale / 16.0, scale / 16.0, scale / 32.0);
    image->SetOrigin(-2.0 * scale, -2.0 * scale, -0.5 * scale);
    scene.Mapper->SetSampleDistance(static_cast<float>(scale / 128.0));
    scene.Property->SetScalarOpacityUnitDistance(0.02 * scale);
    scene.Property->OcclusionOn();
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOff();
    camera->SetPosition(scale, -scale, 4.0 * scale);
    scene.Renderer->ResetCameraClippingRange();
    pictures[i] = scene.RenderFloat();
  }
  for (int i = 1; i < 3; ++i)
  {
    double largest = 0.0;
    for (std::size_t pixel = 0; pixel < pictures[0].size(); ++pixel)
    {
      largest = std::max(largest, 1.0 * std::abs(pictures[i][pixel] - pictures[0][pixel]));
    }
    // a sample of a ray more or less at the volume's faces, where float rounds otherwise
    check.AtMost("scale " + std::to_string(scales[i]), largest, 0.02);
  }
}

// A flat one, a needle from its side and from its end, one voxel thick, and from within.
void CheckShapes(Check& check)
{
  for (const int axis : { 0, 1, 2 })
  {
    OcclusionScene scene(RoofAndFloor);
    vtkNew<vtkTransform> transform;
    double scale[3] = { 0.1, 0.1, 0.1 };
    scale[axis] = 10.0;
    transform->Scale(scale);
    scene.Volume->SetUserTransform(transform);
    scene.Optics->SetVisibilityGridSize(32);
    scene.Property->OcclusionOn();
    scene.Renderer->ResetCamera();
    CheckPixels(check, "1:100 along " + std::to_string(axis), scene);
    const int* size = scene.Optics->GetOcclusionSweep()->GetGridSize();
    check.That(size[0] >= 1 && size[0] <= 32 && size[1] >= 1 && size[1] <= 32 && size[2] >= 1,
      "its grid is " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
        std::to_string(size[2]));
  }
  OcclusionScene thin(Floor);
  vtkNew<vtkImageData> slab;
  slab->SetDimensions(9, 9, 2);
  slab->SetSpacing(0.25, 0.25, 0.1);
  slab->SetOrigin(-1.0, -1.0, 0.0);
  slab->AllocateScalars(VTK_FLOAT, 1);
  slab->GetPointData()->GetScalars()->Fill(1.0);
  thin.Mapper->SetInputDataObject(slab);
  thin.Property->OcclusionOn();
  CheckPixels(check, "one voxel", thin);
  check.Near("one voxel", thin.Red(), OpenFloor(60.0), 0.02);

  OcclusionScene inside(RoofAndFloor);
  inside.Property->OcclusionOn();
  inside.Renderer->GetActiveCamera()->ParallelProjectionOff();
  inside.Renderer->GetActiveCamera()->SetPosition(0.5, 0.2, 0.3);
  inside.Renderer->ResetCameraClippingRange();
  CheckPixels(check, "camera inside", inside);
  check.AtLeast("camera inside", inside.Red(), 0.05);
}

// Thousands of slices of a thin fog: neither drift nor steps. int exp(-t) exp(-t / c) dt over the optical depth 1.
void CheckSlices(Check& check)
{
  OcclusionScene scene([](double, double, double) { return Dense; }, 0.0, 9);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 1.0 - std::exp(-0.02));
  scene.Optics->SetVisibilityGridSize(64);
  scene.Optics->SetVisibilitySliceDistance(0.1);
  scene.Property->SetOcclusionAngle(30.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.1);
  const double seen = MeanOverCone(30.0, [](double cosine) {
    const double rate = 1.0 + 1.0 / cosine;
    return (1.0 - std::exp(-rate)) / rate;
  });
  check.Near("a thousand slices", scene.Visibility(), seen / (1.0 - std::exp(-1.0)), 0.01);
  check.AtLeast("slices", scene.Optics->GetOcclusionSweep()->GetGridSize()[2], 1000);
  // two texels for eight directions, of which OpenGL has 2048 along an axis here
  scene.Optics->SetVisibilityGatherSamples(0);
  check.Near("many slices", scene.Visibility(), seen / (1.0 - std::exp(-1.0)), 0.01);
  check.AtLeast("slices", scene.Optics->GetOcclusionSweep()->GetGridSize()[2], 2000);
}

void CheckWindows(Check& check)
{
  OcclusionScene scene(RoofAndFloor);
  scene.Property->OcclusionOn();
  const double seen = scene.Red(0);
  for (const auto& size :
    { std::pair<int, int>(1, 1), std::pair<int, int>(1, 37), std::pair<int, int>(31, 33) })
  {
    scene.Window->SetSize(size.first, size.second);
    CheckPixels(check, "a window of another size", scene);
  }
  scene.Window->SetSize(33, 33);
  check.Near("back at its size", scene.Red(0), seen, 1.0e-6);
}

// Two renderers of a window, each with its own camera, draw as each alone.
void CheckRenderers(Check& check)
{
  TestScene scene;
  scene.Property->OcclusionOn();
  scene.Window->SetSize(80, 40);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  const std::vector<unsigned char> alone = scene.Render();
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->AddVolume(scene.Volume);
  scene.Window->AddRenderer(other);
  other->ResetCamera();
  const std::vector<unsigned char> both = scene.Render();
  int difference = 0;
  for (std::size_t i = 0; i < both.size(); ++i)
  {
    difference = i / 3 % 80 < 40 ? std::max(difference, std::abs(int(both[i]) - int(alone[i]))) : difference;
  }
  check.Near("a renderer beside another one", difference, 0.0, 0.0);
}

// Not shaded: ambient light alone.
void CheckResizedTable(Check& check)
{
  TestScene scene;
  scene.Window->SetSize(60, 60);
  scene.Renderer->ResetCamera();
  scene.Property->ShadeOff();
  scene.Property->OcclusionOn();
  UseTable2D(scene);
  const std::string fault = FaultOfPixels(scene.RenderFloat());
  check.That(fault.empty(), "a 2D transfer function of few rows: " + fault);
}

void CheckMultiSamples(Check& check)
{
  TestScene plain, several;
  several.Window->SetMultiSamples(4);
  for (TestScene* scene : { &plain, &several })
  {
    scene->Window->SetSize(40, 40);
    scene->Property->OcclusionOn();
  }
  // of the volume's silhouette a pixel has fewer samples
  check.AtMost("multi-sampling", LargestDifference(plain.Render(), several.Render()), 8);
}
}

int TestOcclusionExtremes(int, char*[])
{
  Check check;
  CheckAngles(check);
  CheckKnobs(check);
  CheckOpacities(check);
  CheckScales(check);
  CheckShapes(check);
  CheckSlices(check);
  CheckWindows(check);
  CheckRenderers(check);
  CheckMultiSamples(check);
  CheckResizedTable(check);
  return check.ExitCode();
}
