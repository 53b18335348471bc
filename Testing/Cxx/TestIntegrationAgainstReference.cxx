// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures of the integral in either space, by either classification, with isosurfaces and silhouettes, on a
// target of float against the double-precision reference, whose quadrature knows no tables.

#include "ReferencePictures.h"

#include "vtkLight.h"

#include <functional>

using namespace reference;

namespace
{
struct Setting
{
  const char* name;
  std::function<void(TestScene&)> apply;
  double largestRootMeanSquare = 0.1; // in 255ths
};

void UsePost(TestScene& s)
{
  s.Property->SetIntegrationSpaceToData();
}

void UsePreIntegrated(TestScene& s)
{
  s.Property->SetIntegrationSpaceToData();
  s.Property->SetClassificationToPreIntegrated();
}

void AddSurfaces(TestScene& s)
{
  s.Property->AddIsosurface(0.55, 0.2, 0.9, 0.3, 0.4);
  s.Property->AddIsosurface(0.2, 0.7);
  s.Property->AddIsosurface(0.7, 0.9, 0.2, 0.1, 0.6);
}

// Lights behind, beside and in front of the volume.
void TransmitLight(TestScene& s)
{
  s.Property->SetTransmittedLightToDiffuse();
  for (const double side : { -1.0, 0.2, 1.0 })
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(-3.0 * side, 7.0 * side, 2.0);
    light->SetIntensity(0.5);
    s.Renderer->AddLight(light);
  }
}

const Setting Settings[] = {
  { "post", UsePost },
  { "pre-integrated", UsePreIntegrated },
  { "pre-integrated in physical space",
    [](TestScene& s) { s.Property->SetClassificationToPreIntegrated(); } },
  { "long steps",
    [](TestScene& s) {
      UsePreIntegrated(s);
      s.Mapper->SetSampleDistance(0.15F);
    } },
  { "a unit interval",
    [](TestScene& s) {
      UsePost(s);
      s.Property->SetScalarOpacityUnitInterval(0.05);
    } },
  { "half floats",
    [](TestScene& s) {
      UsePreIntegrated(s);
      s.Optics->SetTablePrecision(16);
    },
    0.3 },
  { "isosurfaces, post",
    [](TestScene& s) {
      UsePost(s);
      AddSurfaces(s);
    } },
  { "isosurfaces, pre-integrated",
    [](TestScene& s) {
      UsePreIntegrated(s);
      AddSurfaces(s);
    } },
  { "exact silhouettes",
    [](TestScene& s) {
      UsePreIntegrated(s);
      AddSurfaces(s);
      s.Property->SetSilhouetteToExact();
    } },
  { "clamped silhouettes",
    [](TestScene& s) {
      UsePreIntegrated(s);
      AddSurfaces(s);
      s.Property->SetSilhouetteToClamped();
    } },
  { "silhouettes by the gradient",
    [](TestScene& s) {
      UsePost(s);
      s.Property->SetSilhouetteToGradient();
    } },
  { "transmitted light, post",
    [](TestScene& s) {
      UsePost(s);
      TransmitLight(s);
    } },
  { "transmitted light with highlights",
    [](TestScene& s) {
      UsePreIntegrated(s);
      AddSurfaces(s);
      TransmitLight(s);
      s.Property->SetTransmittedLightToDiffuseAndSpecular();
    },
    0.3 }, // a light that grazes a surface is on either side of it by rounding: 4.7 codes in one pixel, where it is
           // 0.014 degrees from it, below 0.06 in the others
  { "a steep opacity function",
    [](TestScene& s) {
      UsePost(s);
      s.Property->SetScalarOpacityUnitInterval(0.05);
      s.Opacity->RemoveAllPoints();
      s.Opacity->AddPoint(0.3, 0.0);
      s.Opacity->AddPoint(0.6, 0.6); // highlights by a coefficient that is about 0.15
    } },
  { "parallel",
    [](TestScene& s) {
      UsePreIntegrated(s);
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    } },
};

// Three of four settings leave the surface model; each runs with one, in turn, and unshaded.
void CheckSetting(Check& check, const Setting& setting, int model, bool shade)
{
  TestScene stage;
  stage.Window->SetSize(24, 24); // quadrature takes its time
  Frames frames(stage);
  stage.Opacity->RemoveAllPoints();
  stage.Opacity->AddPoint(0.1, 0.0);
  stage.Opacity->AddPoint(0.4, 0.02);
  stage.Opacity->AddPoint(0.45, 0.0);
  stage.Opacity->AddPoint(0.9, 0.05);
  stage.Opacity->AddPoint(0.95, 0.0); // within the data, where the peak of the reference and the table ends
  stage.Property->SetShade(shade);
  stage.Property->SetReflectanceModel(model);
  stage.Property->SetSpecular(1.0);
  setting.apply(stage);
  auto picture = FloatPicture(stage);
  const Image truth = Render(SceneOf(stage, frames));
  const Difference difference = CompareShown(stage, truth, picture);
  const std::string name =
    std::string(setting.name) + ", " + (shade ? stage.Property->GetReflectanceModelAsString() : "not shaded");
  std::cout << name << ": rms " << 255.0 * difference.rootMeanSquare << "/255, largest "
            << 255.0 * difference.maximum << "/255\n";
  check.That(255.0 * difference.rootMeanSquare < setting.largestRootMeanSquare, name);
}
}

int TestIntegrationAgainstReference(int, char*[])
{
  Check check;
  int model = vtkOpticsVolumeProperty::VTK;
  for (const Setting& setting : Settings)
  {
    CheckSetting(check, setting, vtkOpticsVolumeProperty::VTK, false);
    CheckSetting(check, setting, model, true);
    model = (model + 1) % vtkOpticsVolumeProperty::NumberOfReflectanceModels;
  }
  return check.ExitCode();
}
