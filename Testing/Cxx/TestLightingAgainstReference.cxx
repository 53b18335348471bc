// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures with a lighting transfer function on a target of float against the double-precision
// reference, which has no table: what is left is float, the tables and VTK's steps.

#include "RayCaster.h"
#include "TestScene.h"
#include "vtkLightingTransferFunction.h"

#include "vtkLight.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"

#include <functional>

using namespace reference;

namespace
{
const int PictureSize = 150; // TestScene's

vtkSmartPointer<vtkImageData> FloatPicture(TestScene& scene)
{
  const std::vector<float> pixels = scene.RenderFloat();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(PictureSize, PictureSize, 1);
  picture->AllocateScalars(VTK_FLOAT, 4);
  std::copy(pixels.begin(), pixels.end(), static_cast<float*>(picture->GetScalarPointer()));
  return picture;
}

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

// More opaque inside and outside than between: its inner side has densities that fall with the scalar.
void ShowShell(TestScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.1, 0.2);
  scene.Opacity->AddPoint(0.5, 0.02);
  scene.Opacity->AddPoint(0.9, 0.4);
}

struct Setting
{
  const char* name;
  std::function<void(TestScene&)> apply;
  double largestRootMeanSquare = 0.1; // in 255ths
};

// Without light VTK's steps and tables leave rms 0.05. The table's cells are bilinear, the function is
// the product of two ramps: on the diagonal, where a step of 0 stays, it has a ridge, which 256 points
// blunt. With 16 points a soft edge of 0.1 is one cell wide.
const Setting Settings[] = {
  { "defaults", [](TestScene&) {} },
  { "half a step", [](TestScene& s) { s.Property->SetGradientStepLength(0.5); } },
  { "three steps", [](TestScene& s) { s.Property->SetGradientStepLength(3.0); } },
  { "no step", [](TestScene& s) { s.Property->SetGradientStepLength(0.0); }, 0.3 },
  { "beyond the volume", [](TestScene& s) { s.Property->SetGradientStepLength(100.0); } },
  { "light scale 4", [](TestScene& s) { s.Property->SetLightScale(4.0); }, 0.4 },
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
  { "a table of 4096", [](TestScene& s) { s.Optics->SetLightingTableSize(4096); } },
  { "a table of 16", [](TestScene& s) { s.Optics->SetLightingTableSize(16); }, 4.0 },
};
}

int TestLightingAgainstReference(int, char*[])
{
  Check check;
  for (const Setting& setting : Settings)
  {
    TestScene stage;
    vtkNew<vtkLightingTransferFunction> function;
    const double outside[2] = { 0.0, 0.5 }, inside[2] = { 0.55, 1.0 };
    function->SetSoftness(function->AddBoundary(outside, inside, 0.2, 0.7, 0.5), 0.1);
    stage.Property->SetLightingTransferFunction(function);
    stage.Opacity->RemoveAllPoints();
    stage.Opacity->AddPoint(0.2, 0.0);
    stage.Opacity->AddPoint(0.7, 0.2);
    setting.apply(stage);
    auto picture = FloatPicture(stage);
    const double* background = stage.Renderer->GetBackground();
    const Scene scene = SceneFromVTK(stage.Renderer, stage.Volume, PictureSize, PictureSize);
    const Difference difference =
      Compare(Render(scene), picture, Vector(background[0], background[1], background[2]));
    std::cout << setting.name << ": rms " << 255.0 * difference.rootMeanSquare << "/255, largest "
              << 255.0 * difference.maximum << "/255\n";
    check.That(255.0 * difference.rootMeanSquare < setting.largestRootMeanSquare, setting.name);
    check.That(stage.Optics->GetActiveTerms() == "Reflectance,LightingTransferFunction",
      std::string(setting.name) + ": a term is not active");
  }
  return check.ExitCode();
}
