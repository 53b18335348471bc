// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows of the mapper's lights against rays to the lights in double precision.

#include "LightShadow.h"
#include "ReferencePictures.h"
#include "ShadowScene.h"

#include "vtkMatrix4x4.h"

#include <functional>

using namespace reference;

namespace
{
const int Size = 28;

struct Setting
{
  const char* Name;
  std::function<void(ShadowScene&)> Apply;
  // of the absolute difference, in 255ths: within its own slice a sample is hidden by what the ray has met,
  // not by what the light has; soft ones take 16 directions
  double LargestMean;
};

void Turn(ShadowScene& scene)
{
  vtkNew<vtkMatrix4x4> matrix;
  const double elements[16] = { 0.0, -1.1, 0.0, 0.1, 1.1, 0.0, 0.0, -0.2, 0.0, 0.0, 1.1, 0.1, 0.0, 0.0, 0.0,
    1.0 };
  matrix->DeepCopy(elements);
  scene.Volume->SetUserMatrix(matrix);
  scene.AddSun(2.0, -0.5, 2.0);
}

const Setting Settings[] = {
  { "sun", [](ShadowScene& s) { s.AddSun(1.0, 0.0, 1.0); }, 1.2 },
  { "lamp outside", [](ShadowScene& s) { s.AddLamp(1.0, 0.5, 2.5); }, 1.6 },
  { "lamp inside", [](ShadowScene& s) { s.AddLamp(-0.6, 0.1, 0.7); }, 2.2 },
  { "spot", [](ShadowScene& s) { s.AddLamp(-0.6, 0.1, 0.9)->SetConeAngle(35.0); }, 0.6 },
  { "user matrix", Turn, 1.6 },
  { "half of a shadow", [](ShadowScene& s) { s.AddSun(1.0, 0.0, 1.0)->SetShadowAttenuation(0.5F); }, 0.6 },
  { "two lights of colour",
    [](ShadowScene& s) {
      s.AddSun(1.0, 0.0, 1.0)->SetDiffuseColor(1.0, 0.3, 0.0);
      s.AddLamp(-1.0, -1.0, 2.0)->SetDiffuseColor(0.0, 0.3, 1.0);
    },
    1.3 },
  { "soft sun",
    [](ShadowScene& s) {
      s.AddSun(1.0, 0.0, 1.0);
      s.Property->SetShadowAngle(15.0);
      s.Optics->SetVisibilitySamples(16);
    },
    1.4 },
  { "soft lamp",
    [](ShadowScene& s) {
      s.AddLamp(1.0, 0.5, 2.5);
      s.Property->SetShadowAngle(10.0);
      s.Optics->SetVisibilitySamples(16);
    },
    1.7 },
  { "data space",
    [](ShadowScene& s) {
      s.Property->SetIntegrationSpaceToData();
      s.Property->SetClassificationToPreIntegrated();
      s.Property->SetScalarOpacityUnitInterval(0.2);
      s.AddSun(1.0, 0.0, 1.0);
    },
    3.0 },
};

double MeanOfDifference(const Image& truth, vtkImageData* picture)
{
  const auto* pixels = static_cast<const float*>(picture->GetScalarPointer());
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum += std::abs(truth.pixels[i][c] - pixels[4 * i + c]);
    }
  }
  return 255.0 * sum / (3.0 * static_cast<double>(truth.pixels.size()));
}

void Compare(Check& check, const Setting& setting)
{
  ShadowScene stage;
  stage.Window->SetSize(Size, Size);
  setting.Apply(stage);
  auto picture = FloatPicture(stage);
  Scene scene = SceneFromVTK(stage.Renderer, stage.Volume, Size, Size);
  const Image lit = Render(scene);
  const double angle = stage.Property->GetShadowAngle();
  scene.shadow = LightShadow(scene, angle, 0.02, 32);
  const Image truth = Render(scene);
  const double off = MeanOfDifference(truth, picture);
  const double without = MeanOfDifference(lit, picture);
  std::cout << setting.Name << ": mean " << off << "/255, rms "
            << 255.0 * reference::Compare(truth, picture).rootMeanSquare << "/255; without shadows "
            << without << "/255\n";
  check.AtMost(setting.Name, off, setting.LargestMean);
  check.AtLeast(std::string(setting.Name) + ", without shadows", without, 15.0);
}
}

int TestShadowsAgainstReference(int, char*[])
{
  Check check;
  for (const Setting& setting : Settings)
  {
    Compare(check, setting);
  }
  return check.ExitCode();
}
