// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The reference renderer against pictures of VTK's own mapper, where both draw the same model.

#include "ReferenceScenes.h"
#include "vtkAnalyticVolumeSource.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"

#include <cstdlib>
#include <functional>
#include <stdexcept>

using namespace reference;
using namespace scenes;

namespace
{
const int PictureSize = 160;

// A window with one volume, changed by each case.
struct Stage
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkAnalyticVolumeSource> source;
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  vtkNew<vtkOpticsVolumeProperty> property;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;

  Stage()
  {
    this->source->SetFieldToMarschnerLobb();
    this->source->SetDimensions(48, 48, 48);
    this->source->Update();
    this->opacity->AddPoint(0.0, 0.0);
    this->opacity->AddPoint(0.4, 0.0);
    this->opacity->AddPoint(0.9, 0.7);
    this->color->AddRGBPoint(0.0, 0.1, 0.3, 0.9);
    this->color->AddRGBPoint(1.0, 1.0, 0.6, 0.2);
    this->property->SetScalarOpacity(this->opacity);
    this->property->SetColor(this->color);
    this->property->SetInterpolationTypeToLinear();
    this->property->SetScalarOpacityUnitDistance(0.1);
    this->mapper->SetInputData(this->source->GetOutput());
    this->mapper->AutoAdjustSampleDistancesOff();
    this->mapper->SetSampleDistance(0.02F);
    this->mapper->UseJitteringOff();
    this->volume->SetMapper(this->mapper);
    this->volume->SetProperty(this->property);
    this->renderer->AddVolume(this->volume);
    this->renderer->SetBackground(0.2, 0.25, 0.3);
    this->window->SetMultiSamples(0);
    this->window->OffScreenRenderingOn();
    this->window->AddRenderer(this->renderer);
    this->window->SetSize(PictureSize, PictureSize);
    this->renderer->ResetCamera();
    this->renderer->GetActiveCamera()->Azimuth(25.0);
    this->renderer->GetActiveCamera()->Elevation(15.0);
  }
};

vtkSmartPointer<vtkImageData> PictureOf(vtkRenderWindow* window)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(PictureSize, PictureSize, 1);
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, PictureSize - 1, PictureSize - 1, 0, pixels);
  picture->GetPointData()->SetScalars(pixels);
  return picture;
}

struct Case
{
  const char* name;
  std::function<void(Stage&)> prepare;
  double largestRootMeanSquare; // in 255ths
};

void Shade(Stage& stage)
{
  stage.property->ShadeOn();
  stage.property->SetAmbient(0.2);
  stage.property->SetDiffuse(0.7);
  stage.property->SetSpecular(0.4);
  stage.property->SetSpecularPower(20.0);
}

void Turn(Stage& stage)
{
  vtkNew<vtkMatrix4x4> matrix;
  const double elements[16] = { 0.0, -2.0, 0.0, 1.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 2.0, 3.0, 0.0, 0.0, 0.0,
    1.0 };
  matrix->DeepCopy(elements);
  stage.volume->SetUserMatrix(matrix);
  stage.renderer->ResetCamera();
}

void TurnImage(Stage& stage)
{
  stage.source->GetOutput()->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
  stage.renderer->ResetCamera();
}

vtkLight* AddLight(Stage& stage, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetDiffuseColor(1.0, 0.8, 0.6);
  light->SetSpecularColor(0.6, 0.8, 1.0);
  light->SetAmbientColor(0.1, 0.2, 0.3);
  stage.renderer->AddLight(light);
  return light;
}

const Case Cases[] = {
  // Without highlights, which VTK 9.1 misplaces for all but the headlight (see Shading.cxx).
  { "diffuse, one-sided scene light",
    [](Stage& s) {
      Shade(s);
      s.property->SetSpecular(0.0);
      AddLight(s, 3.0, 2.0, 5.0);
      s.renderer->TwoSidedLightingOff();
    },
    1.0 },
  { "diffuse, two lights",
    [](Stage& s) {
      Shade(s);
      s.property->SetSpecular(0.0);
      AddLight(s, 3.0, 2.0, 5.0);
      AddLight(s, -3.0, 2.0, 2.0)->SetIntensity(0.5);
    },
    1.0 },
  { "diffuse, spot light",
    [](Stage& s) {
      Shade(s);
      s.property->SetSpecular(0.0);
      vtkLight* light = AddLight(s, 2.0, 2.0, 4.0);
      light->PositionalOn();
      // a wide cone: at its edge VTK's sample positions, half a voxel off, would show
      light->SetConeAngle(40.0);
      light->SetExponent(3.0);
      light->SetAttenuationValues(0.5, 0.1, 0.02);
    },
    1.0 },
  { "no shading, perspective", [](Stage&) {}, 1.0 },
  { "no shading, parallel", [](Stage& s) { s.renderer->GetActiveCamera()->ParallelProjectionOn(); }, 1.0 },
  { "no shading, user matrix", Turn, 1.0 },
  { "no shading, direction matrix", TurnImage, 1.0 },
  { "no shading, camera inside",
    [](Stage& s) {
      s.renderer->GetActiveCamera()->SetPosition(0.2, 0.1, 0.3);
      s.renderer->GetActiveCamera()->SetFocalPoint(-1.0, -0.5, -0.7);
      s.renderer->ResetCameraClippingRange();
    },
    1.0 },
  { "Phong, perspective", Shade, 1.0 },
  { "Phong, parallel",
    [](Stage& s) {
      Shade(s);
      s.renderer->GetActiveCamera()->ParallelProjectionOn();
    },
    1.0 },
  { "Phong, sphere",
    [](Stage& s) {
      Shade(s);
      s.source->SetFieldToSphere();
      s.source->Update();
    },
    1.0 },
};

// The settings of our property reach the scene.
void TestSceneFromVTK(Check& check)
{
  Stage stage;
  stage.property->ShadeOn();
  stage.property->SetReflectanceModelToWard();
  stage.property->SetGlossiness(0.3);
  stage.property->SetAnisotropyScale(4.0);
  stage.property->SetScatteringAnisotropy(0.25F);
  stage.property->SpecularFromExtinctionOff();
  stage.window->Render();
  const Scene scene = SceneFromVTK(stage.renderer, stage.volume, PictureSize, PictureSize);
  check.That(scene.reflectance == Reflectance::Ward && scene.glossiness == 0.3 &&
      scene.anisotropyScale == 4.0 && scene.scatteringAnisotropy == 0.25 && !scene.specularFromExtinction,
    "the scene takes the property's optics");
  check.That(scene.lights.size() == 1 && scene.lights[0].headlight, "the renderer's headlight");
  bool threw = false;
  try
  {
    Render(scene);
  }
  catch (const std::invalid_argument&)
  {
    threw = true;
  }
  check.That(threw, "a scene without frames says so");
}
}

int TestReferenceAgainstVTK(int, char*[])
{
  Check check;
  TestSceneFromVTK(check);
  for (const Case& each : Cases)
  {
    Stage stage;
    each.prepare(stage);
    stage.window->Render();
    auto picture = PictureOf(stage.window);
    const Scene scene = SceneFromVTK(stage.renderer, stage.volume, PictureSize, PictureSize);
    const double* background = stage.renderer->GetBackground();
    const Difference difference =
      Compare(Render(scene), picture, Vector(background[0], background[1], background[2]));
    std::cout << each.name << ": rms " << 255.0 * difference.rootMeanSquare << "/255, largest "
              << 255.0 * difference.maximum << "/255\n";
    check.That(255.0 * difference.rootMeanSquare <= each.largestRootMeanSquare, each.name);
  }
  return check.ExitCode();
}
