// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Four pieces of a volume with the ghost layers that their mappers name, drawn one behind the other, are the picture of
// the whole, for every model that looks no farther; so they are with opaque geometry in them, and with the camera inside.
// A pixel differs if bytes can show it.

#include "TestScene.h"

#include "vtkActor.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <functional>

namespace
{
const double Visible = 1.0 / 255.0;
// Rounding of float moves a face by a hundred thousandth of a step: so rarely a sample is in both pieces, or in none.
const double Rare = 1.0e-4;
const int Middle = 13; // of 32 points on each axis: no plane of symmetry

struct Choice
{
  const char* Name;
  std::function<void(TestScene&)> Apply;
};

const Choice Choices[] = {
  { "no light", [](TestScene& scene) { scene.Property->ShadeOff(); } },
  { "no light, jitter",
    [](TestScene& scene) {
      scene.Property->ShadeOff();
      scene.Optics->UseJitteringOn();
    } },
  { "phase function", [](TestScene& scene) { scene.Property->SetReflectanceModelToNone(); } },
  { "Blinn-Phong", [](TestScene& scene) { scene.Property->SetReflectanceModelToBlinnPhong(); } },
  { "Blinn-Phong, empty space skipped",
    [](TestScene& scene) {
      scene.Property->SetReflectanceModelToBlinnPhong();
      scene.Optics->SkipEmptySpaceOn();
    } },
  { "Ward", [](TestScene& scene) { scene.Property->SetReflectanceModelToWard(); } },
  { "Lafortune by curvature",
    [](TestScene& scene) {
      scene.Property->SetReflectanceModelToLafortune();
      scene.Property->SetFrameSourceToCurvature();
    } },
  { "lighting transfer function",
    [](TestScene& scene) {
      vtkNew<vtkLightingTransferFunction> function;
      const double low[2] = { 0.0, 0.45 };
      const double high[2] = { 0.55, 1.0 };
      function->AddBoundary(low, high, 0.1, 0.8, 0.3);
      scene.Property->SetLightingTransferFunction(function);
      scene.Property->SetGradientStepLength(3.0);
    } },
  { "data space, silhouettes",
    [](TestScene& scene) {
      scene.Property->SetIntegrationSpaceToData();
      scene.Property->SetReflectanceModelToBlinnPhong();
      scene.Property->SetScalarOpacityUnitInterval(0.3);
      scene.Property->SetSilhouetteToExact();
    } },
  { "isosurfaces",
    [](TestScene& scene) {
      scene.Property->SetIntegrationSpaceToData();
      scene.Property->SetReflectanceModelToBlinnPhong();
      scene.Property->SetScalarOpacityUnitInterval(1.0);
      scene.Property->AddIsosurface(0.5, 0.6);
    } },
  { "transmitted light",
    [](TestScene& scene) {
      scene.Property->SetIntegrationSpaceToData();
      scene.Property->SetReflectanceModelToBlinnPhong();
      scene.Property->SetScalarOpacityUnitInterval(0.3);
      scene.Property->SetTransmittedLightToDiffuse();
    } },
  { "pre-integrated",
    [](TestScene& scene) {
      scene.Property->SetClassificationToPreIntegrated();
      scene.Property->SetReflectanceModelToBlinnPhong();
    } },
};

// Translucent, so that no ray ends early, and dim enough for the target of bytes that nothing here draws into.
void SetUp(TestScene& scene, const Choice& choice)
{
  scene.Property->SetScalarOpacityUnitDistance(0.5);
  scene.Property->SetAmbient(0.1);
  scene.Property->SetDiffuse(0.5);
  scene.Property->SetSpecular(0.2);
  scene.Optics->SetFramePrecision(32);
  scene.Optics->GetAmbientCovarianceFilter()->SetScalarRange(0.0, 1.0);
  scene.Optics->GetAmbientCovarianceFilter()->SetRadius(3.0);
  choice.Apply(scene);
}

// How the parts of the whole are made.
struct Cut
{
  int MissingLayers = 0;
  bool KnowsWhole = true;
};

// A scene of four volumes in place of the one, from the farthest to the nearest.
class Pieces
{
public:
  Pieces(const Choice& choice, const Cut& cut)
  {
    SetUp(this->Scene, choice);
    this->Scene.Renderer->RemoveVolume(this->Scene.Volume);
    this->Scene.Source->Update();
    for (int piece = 0; piece < 4; ++piece)
    {
      this->AddPiece(choice, cut, piece % 2 == 1, piece < 2);
    }
  }

  TestScene Scene;

private:
  void AddPiece(const Choice& choice, const Cut& cut, bool isUpperX, bool isUpperY)
  {
    TestScene settings; // of which the mapper and the volume are taken
    SetUp(settings, choice);
    vtkImageData* whole = this->Scene.Source->GetOutput();
    int drawn[6];
    whole->GetExtent(drawn);
    drawn[isUpperX ? 0 : 1] = Middle;
    drawn[isUpperY ? 2 : 3] = Middle;
    const int layers = settings.Optics->GetGhostLayers(settings.Property) - cut.MissingLayers;
    int extent[6];
    for (int side = 0; side < 6; ++side)
    {
      const int end = whole->GetExtent()[side];
      extent[side] =
        side % 2 == 0 ? std::max(drawn[side] - layers, end) : std::min(drawn[side] + layers, end);
    }
    vtkNew<vtkImageData> image;
    image->DeepCopy(whole);
    image->Crop(extent);
    settings.Optics->SetInputData(image);
    settings.Optics->SetDrawnExtent(drawn);
    if (cut.KnowsWhole)
    {
      settings.Optics->SetWholeExtent(whole->GetExtent());
    }
    settings.Renderer->RemoveVolume(settings.Volume);
    this->Scene.Renderer->AddVolume(settings.Volume);
  }
};

vtkSmartPointer<vtkActor> MakeSphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.35);
  sphere->SetCenter(-0.1, -0.1, 0.1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

double ShareOfPixels(const std::vector<float>& a, const std::vector<float>& b)
{
  if (a.size() != b.size() || !AreFinite(a) || !AreFinite(b))
  {
    return 1.0;
  }
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); i += 4)
  {
    different += !std::equal(a.begin() + i, a.begin() + i + 4, b.begin() + i,
      [](float one, float other) { return std::abs(one - other) <= Visible; });
  }
  return 4.0 * static_cast<double>(different) / static_cast<double>(a.size());
}

double Compare(
  const Choice& choice, const Cut& cut, const std::function<void(TestScene&)>& change = [](TestScene&) {})
{
  TestScene whole;
  SetUp(whole, choice);
  change(whole);
  Pieces pieces(choice, cut);
  change(pieces.Scene);
  return ShareOfPixels(whole.RenderFloat(), pieces.Scene.RenderFloat());
}
}

int TestPieces(int, char*[])
{
  Check check;
  for (const Choice& choice : Choices)
  {
    check.AtMost(choice.Name, Compare(choice, Cut()), Rare);
  }
  for (const Choice* choice : { &Choices[0], &Choices[3], &Choices[8] })
  {
    const auto addSphere = [](TestScene& scene) { scene.Renderer->AddActor(MakeSphere()); };
    check.AtMost(std::string(choice->Name) + ", geometry", Compare(*choice, Cut(), addSphere), Rare);
    const auto moveInside = [](TestScene& scene) {
      scene.Renderer->GetActiveCamera()->SetPosition(0.3, -0.6, 0.2);
      scene.Renderer->ResetCameraClippingRange();
    };
    check.AtMost(std::string(choice->Name) + ", inside", Compare(*choice, Cut(), moveInside), Rare);
  }
  // What the layers and the whole's extent are for.
  check.AtLeast("no ghost layers", Compare(Choices[7], Cut{ 4, true }), 0.01);
  check.AtLeast("samples counted anew", Compare(Choices[0], Cut{ 0, false }), 0.01);
  return check.ExitCode();
}
