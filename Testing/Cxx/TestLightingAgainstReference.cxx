// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures with a lighting transfer function on a target of float against the double-precision
// reference, which has no table: what is left is float, the tables and VTK's steps.

#include "ReferencePictures.h"
#include "SmallScene.h"

#include "vtkLight.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"

#include <functional>

using namespace reference;

namespace
{
void Turn(TestScene& scene)
{
  vtkNew<vtkMatrix4x4> matrix;
  const double elements[16] = { 0.0, -1.2, 0.0, 0.1, 1.2, 0.0, 0.0, -0.2, 0.0, 0.0, 1.2, 0.1, 0.0, 0.0, 0.0,
    1.0 };
  matrix->DeepCopy(elements);
  scene.Volume->SetUserMatrix(matrix);
}

void TurnDirections(TestScene& scene)
{
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.Source->GetOutput());
  const double directions[9] = { 0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0 };
  image->SetDirectionMatrix(directions);
  scene.Mapper->SetInputData(image);
}

void AddSun(TestScene& scene)
{
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(3.0, -2.0, 4.0);
  sun->SetDiffuseColor(1.0, 0.8, 0.6);
  scene.Renderer->AddLight(sun);
}

// A thin shell before a ball: in the lit boundary the opacity falls with the scalar, then rises, so that
// light fades and changes sides.
void ShowShell(TestScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.35, 0.0);
  scene.Opacity->AddPoint(0.45, 0.1);
  scene.Opacity->AddPoint(0.6, 0.05);
  scene.Opacity->AddPoint(0.9, 0.3);
}

// In data space light is that of the segment's end.
void IntegrateInData(TestScene& scene)
{
  scene.Window->SetSize(24, 24); // quadrature takes its time
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetScalarOpacityUnitInterval(0.05);
}

struct Setting
{
  const char* name;
  std::function<void(TestScene&)> apply;
  double largestRootMeanSquare = 0.1; // in 255ths
};

// Without light VTK's steps and tables leave rms 0.05. The table's cells are bilinear, the function is
// the product of two ramps: on the diagonal, where a step of 0 stays, it has a ridge, which 256 points
// blunt and 1024 do not. With 16 points a soft edge of 0.1 is one cell wide.
const Setting Settings[] = {
  { "on the fly", [](TestScene&) {} },
  { "half a step", [](TestScene& s) { s.Property->SetGradientStepLength(0.5); } },
  { "three steps", [](TestScene& s) { s.Property->SetGradientStepLength(3.0); } },
  { "no step", [](TestScene& s) { s.Property->SetGradientStepLength(0.0); }, 0.3 },
  { "no step, a table of 1024",
    [](TestScene& s) {
      s.Property->SetGradientStepLength(0.0);
      s.Optics->SetLightingTableSize(1024);
    } },
  { "beyond the volume", [](TestScene& s) { s.Property->SetGradientStepLength(100.0); } },
  { "light scale 4", [](TestScene& s) { s.Property->SetLightScale(4.0); }, 0.2 },
  { "one-sided", [](TestScene& s) { s.Renderer->TwoSidedLightingOff(); } },
  { "hybrid normals",
    [](TestScene& s) {
      ShowShell(s);
      s.Property->HybridNormalsOn();
    } },
  { "user matrix", Turn },
  { "direction matrix", TurnDirections },
  { "uneven spacing", [](TestScene& s) { s.Source->SetDimensions(32, 20, 44); } },
  { "two lights", AddSun },
  { "16 bits", [](TestScene& s) { s.Optics->SetTablePrecision(16); } },
  { "a table of 1024", [](TestScene& s) { s.Optics->SetLightingTableSize(1024); } },
  { "a table of 16", [](TestScene& s) { s.Optics->SetLightingTableSize(16); }, 1.0 },
  { "in data space", IntegrateInData },
  { "in data space, pre-integrated",
    [](TestScene& s) {
      IntegrateInData(s);
      s.Property->SetClassificationToPreIntegrated();
    } },
  { "isosurfaces where light begins, steps of half a voxel",
    [](TestScene& s) {
      IntegrateInData(s);
      s.Property->AddIsosurface(0.2, 0.9, 0.2, 0.1, 0.7);
      s.Property->AddIsosurface(0.55, 0.2, 0.9, 0.3, 0.4);
      s.Property->SetGradientStepLength(2.0);
      s.Property->SetLightScale(2.0);
      s.Optics->SetLightingTableSize(1024);
      s.Source->SetDimensions(12, 12, 12);
      s.Mapper->SetSampleDistance(0.09F);
    } },
};

// Over the normals that the reference has, too; the first row is the mapper's default.
const Setting SettingsOfStoredNormals[] = {
  { "stored gradient", [](TestScene&) {} },
  { "stored gradient, 8 bits", [](TestScene& s) { s.Optics->SetFramePrecision(8); }, 1.0 },
  { "stored gradient, hybrid normals",
    [](TestScene& s) {
      ShowShell(s);
      s.Property->HybridNormalsOn();
    } },
  { "Blinn-Phong", [](TestScene& s) { s.Property->SetReflectanceModelToBlinnPhong(); } },
  { "Blinn-Phong, on the fly",
    [](TestScene& s) {
      s.Property->SetReflectanceModelToBlinnPhong();
      s.Optics->SetScalarGradientToCentralDifferences();
    } },
  { "Blinn-Phong, hybrid normals",
    [](TestScene& s) {
      ShowShell(s);
      s.Property->SetReflectanceModelToBlinnPhong();
      s.Property->HybridNormalsOn();
    } },
  { "Ward", [](TestScene& s) { s.Property->SetReflectanceModelToWard(); } },
  { "Ward, hybrid normals",
    [](TestScene& s) {
      ShowShell(s);
      s.Property->SetReflectanceModelToWard();
      s.Property->HybridNormalsOn();
    } },
};

void LightBoundary(TestScene& stage)
{
  vtkNew<vtkLightingTransferFunction> function;
  const double outside[2] = { 0.0, 0.5 }, inside[2] = { 0.55, 1.0 };
  function->SetSoftness(function->AddBoundary(outside, inside, 0.2, 0.7, 0.5), 0.1);
  stage.Property->SetLightingTransferFunction(function);
  stage.Opacity->RemoveAllPoints();
  stage.Opacity->AddPoint(0.2, 0.0);
  stage.Opacity->AddPoint(0.7, 0.2);
}

void CheckPicture(
  Check& check, const Setting& setting, TestScene& stage, vtkImageData* picture, const Scene& scene)
{
  const Difference difference = CompareShown(stage, Render(scene), picture);
  std::cout << setting.name << ": rms " << 255.0 * difference.rootMeanSquare << "/255, largest "
            << 255.0 * difference.maximum << "/255\n";
  check.That(255.0 * difference.rootMeanSquare < setting.largestRootMeanSquare, setting.name);
  check.That(stage.Optics->GetActiveTerms().find("Reflectance,LightingTransferFunction") == 0,
    std::string(setting.name) + ": the terms are " + stage.Optics->GetActiveTerms());
}
}

int TestLightingAgainstReference(int, char*[])
{
  Check check;
  for (const Setting& setting : Settings)
  {
    SmallScene stage;
    LightBoundary(stage);
    stage.Optics->SetScalarGradientToCentralDifferences();
    setting.apply(stage);
    const auto picture = FloatPicture(stage); // makes the headlight
    const int* size = stage.Window->GetSize();
    CheckPicture(
      check, setting, stage, picture, SceneFromVTK(stage.Renderer, stage.Volume, size[0], size[1]));
  }
  for (const Setting& setting : SettingsOfStoredNormals)
  {
    SmallScene stage;
    Frames frames(stage);
    LightBoundary(stage);
    setting.apply(stage);
    const auto picture = FloatPicture(stage);
    CheckPicture(check, setting, stage, picture, SceneOf(stage, frames));
  }
  return check.ExitCode();
}
