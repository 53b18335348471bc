// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes whose settings change one after the other: what changes the source links one program, and only the first time;
// anything else none. TestParameterLinks has every parameter by itself.

#include "SmallScene.h"

#include <functional>

namespace
{
int LinksOf(TestScene& scene, const std::function<void()>& change)
{
  scene.Window->Render();
  const int before = scene.Optics->GetProgramLinkCount();
  change();
  scene.Window->Render();
  scene.Window->Render();
  return scene.Optics->GetProgramLinkCount() - before;
}

struct Expectation
{
  Check& Result;
  TestScene& Scene;

  void operator()(int links, const std::string& name, const std::function<void()>& change)
  {
    const int actual = LinksOf(this->Scene, change);
    this->Result.That(actual == links,
      name + " linked " + std::to_string(actual) + " programs, not " + std::to_string(links));
  }
};

void TestReflectance(Check& check)
{
  SmallScene scene;
  vtkOpticsVolumeProperty* property = scene.Property;
  property->SetReflectanceModelToWard();
  Expectation expect{ check, scene };
  expect(0, "the camera", [&] { scene.Renderer->GetActiveCamera()->Azimuth(10.0); });
  expect(0, "the transfer function", [&] { scene.Opacity->AddPoint(0.8, 0.9); });
  expect(0, "two-sided lighting", [&] { scene.Renderer->TwoSidedLightingOff(); });
  expect(1, "ReflectanceModel", [&] { property->SetReflectanceModelToLafortune(); });
  expect(0, "a ReflectanceModel used before", [&] { property->SetReflectanceModelToWard(); });
  expect(1, "ExtinctionGradient", [&] { scene.Optics->SetExtinctionGradientToCentralDifferences(); });
}

void TestIntegration(Check& check)
{
  SmallScene scene;
  vtkOpticsVolumeProperty* property = scene.Property;
  property->SetIntegrationSpaceToData();
  Expectation expect{ check, scene };
  expect(0, "the opacity function", [&] { scene.Opacity->AddPoint(0.8, 0.9); });
  expect(0, "the colour function", [&] { scene.Color->AddRGBPoint(0.8, 0.9, 0.1, 0.1); });
  expect(1, "the first isosurface", [&] { property->AddIsosurface(0.5, 0.5); });
  expect(0, "the second isosurface", [&] { property->AddIsosurface(0.7, 1.0, 0.0, 0.0, 0.5); });
  expect(0, "no isosurface, as before", [&] { property->RemoveAllIsosurfaces(); });
  expect(1, "Silhouette", [&] { property->SetSilhouetteToExact(); });
  expect(1, "Classification", [&] { property->SetClassificationToPreIntegrated(); });
  expect(0, "the opacity function in a table", [&] { scene.Opacity->AddPoint(0.9, 0.2); });
  expect(0, "the sample distance", [&] { scene.Mapper->SetSampleDistance(0.05F); });
  expect(0, "ScalarGradient CentralDifferences, which Automatic is here",
    [&] { scene.Optics->SetScalarGradientToCentralDifferences(); });
  expect(1, "ScalarGradient", [&] { scene.Optics->SetScalarGradientToStored(); });
}

// Editing boundaries, in particular, is interactive.
void TestLighting(Check& check)
{
  SmallScene scene;
  vtkOpticsVolumeProperty* property = scene.Property;
  LightEverywhere(scene, 0.2, 0.7, 0.2);
  vtkLightingTransferFunction* function = property->GetLightingTransferFunction();
  Expectation expect{ check, scene };
  const double low[2] = { 0.0, 0.4 }, high[2] = { 0.6, 1.0 };
  const std::vector<unsigned char> before = scene.Render();
  expect(0, "a boundary's range", [&] { function->SetRange(0, 0, 0.0, 0.5); });
  check.That(LargestDifference(before, scene.Render()) > 10, "the edit of a boundary is not drawn");
  expect(0, "another boundary", [&] { function->AddBoundary(low, high, 0.1, 0.8, 0.3); });
  expect(0, "the opacity function", [&] { scene.Opacity->AddPoint(0.8, 0.9); });
  expect(
    0, "ScalarGradient Stored, which Automatic is here", [&] { scene.Optics->SetScalarGradientToStored(); });
  expect(1, "HybridNormals", [&] { property->HybridNormalsOn(); });
  expect(0, "the opacity function with hybrid normals", [&] { scene.Opacity->AddPoint(0.7, 0.2); });
  expect(1, "LightingSamples", [&] { scene.Optics->SetLightingSamplesToExtrapolated(); });
  expect(1, "ScalarGradient", [&] { scene.Optics->SetScalarGradientToCentralDifferences(); });
}
}

int TestProgramLinks(int, char*[])
{
  Check check;
  TestReflectance(check);
  TestIntegration(check);
  TestLighting(check);
  return check.ExitCode();
}
