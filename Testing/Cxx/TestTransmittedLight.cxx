// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Light from behind: where there is none, VTK's model in our lighting is VTK's own; what shines through does not
// depend on the step; an opaque surface transmits nothing; and no sample changes sides at once.

#include "TestScene.h"

#include "vtkLight.h"

namespace
{
void LightFrom(TestScene& scene, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(light);
}

// VTK lights a headlight from the eye's place, and its highlights as if the volume's texture coordinates were
// centred: only a scene light's diffuse part is the same.
void TestLightsInFront(Check& check)
{
  TestScene stock, ours;
  for (TestScene* scene : { &stock, &ours })
  {
    scene->Property->SetIntegrationSpaceToData();
    scene->Property->SetAmbient(0.0);
    scene->Property->SetSpecular(0.0);
    scene->Renderer->GetActiveCamera()->ParallelProjectionOn(); // every ray has the light in front
    LightFrom(*scene, 1.0, -2.5, 1.2);
  }
  ours.Property->SetTransmittedLightToDiffuseAndSpecular();
  const int difference = LargestDifference(stock.Render(), ours.Render());
  // one code of rounding
  check.That(difference <= 1, "lights in front: differs by " + std::to_string(difference));
  check.That(stock.Optics->GetActiveTerms() == "Integration", "lights in front: stock lighting");
  check.That(ours.Optics->GetActiveTerms() == "Reflectance,Integration", "lights in front: own lighting");
}

// Red of a peak that a light shines through, at the middle of the picture.
double RedThrough(double step, double unitInterval)
{
  TestScene scene;
  LightFrom(scene, -2.0, 5.0, -2.4);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.3, 0.0);
  scene.Opacity->AddPoint(0.4, 0.7);
  scene.Opacity->AddPoint(0.5, 0.0);
  scene.Property->SetScalarOpacityUnitInterval(unitInterval);
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetClassificationToPreIntegrated();
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(1.0);
  scene.Property->SetSpecular(0.0);
  scene.Property->SetTransmittedLightToDiffuse();
  scene.Optics->SetPreIntegrationTableSize(1024);
  scene.Mapper->SetSampleDistance(static_cast<float>(step));
  const std::vector<float> pixels = scene.RenderFloat();
  return pixels[4 * (75 * 150 + 75)];
}

void TestSteps(Check& check)
{
  const double fine = RedThrough(0.004, 0.1);
  check.AtLeast("light shines through a peak", fine, 0.05);
  for (const double step : { 0.01, 0.03, 0.06 })
  {
    // the place where a part is lit moves by up to a step, and its normal with it
    check.Near("what shines through at a step of " + std::to_string(step), RedThrough(step, 0.1), fine, 0.02);
  }
  check.AtMost("an opaque peak", RedThrough(0.01, 0.001), 0.005);
}

// Planes of equal scalars, and a light that grazes all of them, at an angle in radians. Scattered light has no cosine:
// much of it is there.
std::vector<float> PictureLitAt(double angle)
{
  TestScene scene;
  scene.Source->SetFieldToLinearRamp();
  LightFrom(scene, 0.0, -std::cos(angle), std::sin(angle));
  scene.Property->SetReflectanceModelToBlinnPhong();
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetScalarOpacityUnitInterval(0.1);
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(0.9);
  scene.Property->SetSpecular(0.0);
  scene.Property->SetTransmittedLightToDiffuse();
  return scene.RenderFloat();
}

double LargestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(double(a[i]) - double(b[i])));
  }
  return largest;
}

// What rounding makes of a normal is within one code; far away the sides differ.
void TestSides(Check& check)
{
  const std::vector<float> before = PictureLitAt(-2.5e-6);
  check.AtMost("across, by 5e-6", LargestDifference(before, PictureLitAt(2.5e-6)), 1.0 / 255.0);
  check.AtLeast("across, by a tenth", LargestDifference(PictureLitAt(-0.05), PictureLitAt(0.05)), 0.1);
}
}

int TestTransmittedLight(int, char*[])
{
  Check check;
  TestLightsInFront(check);
  TestSteps(check);
  TestSides(check);
  return check.ExitCode();
}
