// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper's pictures on a target of float against the double-precision reference, over the same
// normals and frames: what is left is float, the opacity table and VTK's steps.

#include "ReferencePictures.h"

#include "vtkLight.h"
#include "vtkMatrix4x4.h"

#include <functional>

using namespace reference;

namespace
{
struct Setting
{
  const char* name;
  std::function<void(TestScene&)> apply;
  double largestRootMeanSquare = 0.1; // in 255ths
  bool isOfSurfaces = true;           // the phase function alone does not depend on it
};

void Turn(TestScene& scene)
{
  vtkNew<vtkMatrix4x4> matrix;
  const double elements[16] = { 0.0, -1.2, 0.0, 0.1, 1.2, 0.0, 0.0, -0.2, 0.0, 0.0, 1.2, 0.1, 0.0, 0.0, 0.0,
    1.0 };
  matrix->DeepCopy(elements);
  scene.Volume->SetUserMatrix(matrix);
}

void AddLights(TestScene& scene)
{
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(3.0, -2.0, 4.0);
  sun->SetDiffuseColor(1.0, 0.8, 0.6);
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPositional(1);
  lamp->SetPosition(-1.0, -2.0, 0.5);
  lamp->SetConeAngle(60.0);
  lamp->SetAttenuationValues(0.5, 0.2, 0.1);
  scene.Renderer->AddLight(sun);
  scene.Renderer->AddLight(lamp);
}

const Setting Settings[] = {
  { "defaults", [](TestScene&) {}, 0.1, false },
  { "16 bits", [](TestScene& s) { s.Optics->SetFramePrecision(16); } },
  { "8 bits", [](TestScene& s) { s.Optics->SetFramePrecision(8); }, 1.0 },
  { "user matrix", Turn, 0.1, false },
  { "central differences", [](TestScene& s) { s.Optics->SetExtinctionGradientToCentralDifferences(); } },
  { "no extinction", [](TestScene& s) { s.Property->SpecularFromExtinctionOff(); } },
  { "forward scattering", [](TestScene& s) { s.Property->SetScatteringAnisotropy(0.5F); }, 0.1, false },
  { "two lights", AddLights, 0.1, false },
  { "one-sided", [](TestScene& s) { s.Renderer->TwoSidedLightingOff(); } },
  { "parallel", [](TestScene& s) { s.Renderer->GetActiveCamera()->ParallelProjectionOn(); } },
  { "falling opacity",
    [](TestScene& s) {
      s.Opacity->RemoveAllPoints();
      s.Opacity->AddPoint(0.2, 0.1);
      s.Opacity->AddPoint(0.7, 0.0);
    } },
};
}

int TestMapperAgainstReference(int, char*[])
{
  Check check;
  Image phaseFunctionOnly;
  for (int model = vtkOpticsVolumeProperty::None; model <= vtkOpticsVolumeProperty::Lafortune; ++model)
  {
    for (const Setting& setting : Settings)
    {
      if (model == vtkOpticsVolumeProperty::None && setting.isOfSurfaces)
      {
        continue;
      }
      TestScene stage;
      Frames frames(stage);
      stage.Property->SetReflectanceModel(model);
      stage.Property->SetSpecular(1.0);
      setting.apply(stage);
      auto picture = FloatPicture(stage);
      const Image truth = Render(SceneOf(stage, frames));
      const Difference difference = CompareShown(stage, truth, picture);
      const std::string name =
        std::string(stage.Property->GetReflectanceModelAsString()) + ", " + setting.name;
      std::cout << name << ": rms " << 255.0 * difference.rootMeanSquare << "/255, largest "
                << 255.0 * difference.maximum << "/255\n";
      check.That(255.0 * difference.rootMeanSquare < setting.largestRootMeanSquare, name);
      if (&setting == &Settings[0])
      {
        phaseFunctionOnly = model == vtkOpticsVolumeProperty::None ? truth : phaseFunctionOnly;
        const double highlight = 255.0 * Compare(truth, phaseFunctionOnly).rootMeanSquare;
        std::cout << name << ": highlights of rms " << highlight << "/255\n";
        check.That(model == vtkOpticsVolumeProperty::None || highlight > 5.0, name + " has highlights");
      }
    }
  }
  return check.ExitCode();
}
