// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever hides the volume from the eye's rays hides it from the sweep: where a pane of glass above a white
// floor is cut, masked or classified away, the floor is as bright as without it. And the pane darkens the floor by
// every way to classify it.

#include "OcclusionTesting.h"
#include "SupportedSettings.h"

#include "vtkPlane.h"

namespace
{
double Pane(double, double, double z)
{
  return z < FloorHeight ? Dense : (std::abs(z + 0.1) < 0.12 ? Glass : 0.0);
}

struct Hiding
{
  const char* Name;
  std::function<void(OcclusionScene&)> Hide;
};

// Takes away what is above z = -0.3.
const std::vector<Hiding> Hidings = {
  { "clipping plane",
    [](OcclusionScene& scene) {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.0, 0.0, -0.3);
      plane->SetNormal(0.0, 0.0, -1.0);
      scene.Mapper->AddClippingPlane(plane);
    } },
  { "cropping",
    [](OcclusionScene& scene) {
      scene.Mapper->SetCroppingRegionPlanes(-2.0, 2.0, -2.0, 2.0, -0.5, -0.3);
      scene.Mapper->SetCroppingRegionFlagsToSubVolume();
      scene.Mapper->CroppingOn();
    } },
  { "mask",
    [](OcclusionScene& scene) {
      vtkNew<vtkImageData> mask;
      auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
      mask->CopyStructure(image);
      mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
      {
        static_cast<unsigned char*>(mask->GetScalarPointer())[i] = mask->GetPoint(i)[2] < -0.3 ? 255 : 0;
      }
      scene.Mapper->SetMaskInput(mask);
      scene.Mapper->SetMaskTypeToBinary();
    } },
  { "transfer function",
    [](OcclusionScene& scene) {
      scene.Opacity->RemovePoint(0.2);
      scene.Opacity->RemovePoint(0.3);
    } },
};

void CheckHiding(Check& check)
{
  for (const Hiding& hiding : Hidings)
  {
    const std::string name = hiding.Name;
    OcclusionScene open(Floor, 0.3);
    OcclusionScene scene(Pane, 0.3);
    open.Optics->SetVisibilityGridSize(64);
    scene.Optics->SetVisibilityGridSize(64);
    check.AtMost(name + ": behind the pane", scene.Visibility(), 0.3 * open.Visibility());
    hiding.Hide(open);
    hiding.Hide(scene);
    check.Near(name + ": without the pane", scene.Visibility(), open.Visibility(), 1.0e-3);
    check.AtLeast(name + ": without the pane", open.Visibility(), 0.35);
  }
}

// How much of the open floor's light is left behind the pane; the same in all, within the difference of their
// integrals.
void CheckClassifications(Check& check)
{
  const auto share = [](const std::function<void(OcclusionScene&)>& apply) {
    OcclusionScene open(Floor);
    OcclusionScene scene(Pane, 0.1);
    for (OcclusionScene* each : { &open, &scene })
    {
      each->Optics->SetVisibilityGridSize(64);
      each->Optics->SetVisibilityGatherSamples(0); // not all of the classifications gather
    }
    apply(open);
    apply(scene);
    return scene.Visibility() / open.Visibility();
  };
  const double plain = share([](OcclusionScene&) {});
  check.Near("the pane lets a part of the light through", plain, 0.2, 0.12);
  check.Near("pre-integrated",
    share([](OcclusionScene& scene) { scene.Property->SetClassificationToPreIntegrated(); }), plain, 0.05);
  check.Near("gradient opacity of 1", share([](OcclusionScene& scene) {
    vtkNew<vtkPiecewiseFunction> one;
    one->AddPoint(0.0, 1.0);
    one->AddPoint(1.0, 1.0);
    scene.Property->SetGradientOpacity(one);
  }),
    plain, 0.01);
  const double edges = share([](OcclusionScene& scene) {
    vtkNew<vtkPiecewiseFunction> steep;
    steep->AddPoint(0.0, 0.0);
    steep->AddPoint(0.14, 0.0);
    steep->AddPoint(0.2, 1.0);
    scene.Property->SetGradientOpacity(steep);
  });
  check.AtLeast("a gradient opacity that leaves the pane its edges", edges, 2.0 * plain);
  check.Near("lit, by the ambient part", share([](OcclusionScene& scene) {
    scene.Property->ShadeOn();
    scene.Property->SetAmbient(1.0);
    scene.Property->SetDiffuse(0.0);
    scene.Property->SetSpecular(0.0);
  }),
    plain, 0.02);
  check.Near("lit by a model", share([](OcclusionScene& scene) {
    scene.Property->ShadeOn();
    scene.Property->SetReflectanceModelToBlinnPhong();
    scene.Property->SetAmbient(1.0);
    scene.Property->SetDiffuse(0.0);
    scene.Property->SetSpecular(0.0);
  }),
    plain, 0.02);
}

// A black isosurface of opacity one half, over a white one that is opaque: no direction crosses it twice.
void CheckIsosurfaces(Check& check)
{
  const auto ramp = [](double, double, double z) { return 0.5 - z; };
  for (const bool isPreIntegrated : { false, true })
  {
    OcclusionScene scene(ramp);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.0, 0.0);
    scene.Property->SetIntegrationSpaceToData();
    scene.Property->SetClassification(isPreIntegrated);
    scene.Property->AddIsosurface(0.9, 1.0, 1.0, 1.0, 1.0);
    check.Near("an isosurface alone", scene.Visibility(), 1.0, 0.01);
    scene.Property->AddIsosurface(0.5, 0.0, 0.0, 0.0, 0.5);
    check.Near("an isosurface under another one", scene.Visibility(), 0.5, 0.01);
    scene.Property->AddIsosurface(0.3, 0.0, 0.0, 0.0, 0.5);
    check.Near("an isosurface under two", scene.Visibility(), 0.25, 0.01);
  }
}

// A scene of each kind grows darker, and nowhere brighter.
void CheckKinds(Check& check)
{
  for (const Row& row : Rows)
  {
    const std::string name = row.Name;
    TestScene scene;
    scene.Window->SetSize(40, 40);
    scene.Optics->SetVisibilityGridSize(32);
    scene.Property->ShadeOff();
    row.Apply(scene);
    const std::vector<unsigned char> open = scene.Render();
    scene.Property->OcclusionOn();
    const Warnings warnings(scene.Mapper);
    const std::vector<unsigned char> darker = scene.Render();
    int brighter = 0;
    int dark = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      brighter = std::max(brighter, int(darker[i]) - int(open[i]));
      dark = std::max(dark, int(open[i]) - int(darker[i]));
    }
    check.AtMost(name + ": brighter", brighter, 1);
    check.That(dark > 20, name + ": is darker by " + std::to_string(dark));
    check.That(warnings.Texts.empty(), name + ": warnings");
    for (const std::string& text : warnings.Texts)
    {
      std::cout << text << std::endl;
    }
  }
}

// Switched off it leaves nothing behind.
void CheckOff(Check& check)
{
  TestScene scene;
  scene.Window->SetSize(40, 40);
  const std::vector<unsigned char> stock = scene.Render();
  scene.Property->OcclusionOn();
  scene.Render();
  check.That(
    scene.Optics->GetActiveTerms() == "Reflectance,Occlusion", "terms: " + scene.Optics->GetActiveTerms());
  check.AtLeast("memory", scene.Optics->GetTermMemorySize(), 1);
  scene.Property->OcclusionOff();
  check.Near("off again", LargestDifference(scene.Render(), stock), 0, 0);
  check.That(scene.Optics->GetActiveTerms().empty(), "terms: " + scene.Optics->GetActiveTerms());
  check.Near("memory without", scene.Optics->GetTermMemorySize(), 0, 0);
}
}

int TestOcclusionSettings(int, char*[])
{
  Check check;
  CheckHiding(check);
  CheckClassifications(check);
  CheckIsosurfaces(check);
  CheckKinds(check);
  CheckOff(check);
  return check.ExitCode();
}
