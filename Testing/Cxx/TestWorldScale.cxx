// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The world scaled by 1e-6 or 1e6, together with every length in it, looks the same.

#include "TestScene.h"

#include "vtkLight.h"

namespace
{
const int Models[] = { vtkOpticsVolumeProperty::None, vtkOpticsVolumeProperty::BlinnPhong,
  vtkOpticsVolumeProperty::Ward, vtkOpticsVolumeProperty::Lafortune };

struct Choice
{
  int Model;
  bool Central;
  bool Curvature;
};

void AddLight(TestScene& scene, double scale)
{
  vtkNew<vtkLight> light;
  light->SetPositional(true);
  light->SetPosition(2.0 * scale, -2.0 * scale, 3.0 * scale);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(40.0);
  scene.Renderer->SetAutomaticLightCreation(false);
  scene.Renderer->AddLight(light);
}

vtkSmartPointer<vtkImageData> Scaled(TestScene& scene, double scale)
{
  scene.Source->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(scene.Source->GetOutput());
  const double* spacing = image->GetSpacing();
  image->SetSpacing(scale * spacing[0], scale * spacing[1], scale * spacing[2]);
  const double* origin = image->GetOrigin();
  image->SetOrigin(scale * origin[0], scale * origin[1], scale * origin[2]);
  return image;
}

std::vector<unsigned char> Draw(const Choice& choice, double scale)
{
  TestScene scene;
  scene.Property->SetReflectanceModel(choice.Model);
  scene.Property->SetFrameSource(
    choice.Curvature ? vtkOpticsVolumeProperty::Curvature : vtkOpticsVolumeProperty::Covariance);
  scene.Property->SetSpecular(0.6);
  scene.Optics->SetExtinctionGradient(
    choice.Central ? vtkOpticsVolumeMapper::CentralDifferences : vtkOpticsVolumeMapper::Stored);
  scene.Mapper->SetInputData(Scaled(scene, scale));
  scene.Mapper->SetSampleDistance(static_cast<float>(0.02 * scale));
  scene.Property->SetScalarOpacityUnitDistance(0.05 * scale);
  AddLight(scene, scale);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(1.0 * scale, -2.5 * scale, 1.2 * scale);
  scene.Renderer->ResetCameraClippingRange();
  return scene.Render();
}
}

int TestWorldScale(int, char*[])
{
  Check check;
  std::vector<Choice> choices = { { vtkOpticsVolumeProperty::VTK, false, false },
    { vtkOpticsVolumeProperty::Ward, false, true } };
  for (const int model : Models)
  {
    choices.push_back({ model, false, false });
    choices.push_back({ model, true, false });
  }
  for (const Choice& choice : choices)
  {
    const std::vector<unsigned char> expected = Draw(choice, 1.0);
    const int brightest = *std::max_element(expected.begin(), expected.end());
    check.AtLeast("brightest pixel of model " + std::to_string(choice.Model), brightest, 120);
    for (const double scale : { 1.0e-6, 1.0e6 })
    {
      const int difference = LargestDifference(expected, Draw(choice, scale));
      check.AtMost("model " + std::to_string(choice.Model) +
          (choice.Central ? " by central differences" : "") + (choice.Curvature ? " by curvature" : "") +
          ", world scaled by " + std::to_string(scale) + ": largest difference",
        difference, 2);
    }
  }
  return check.ExitCode();
}
