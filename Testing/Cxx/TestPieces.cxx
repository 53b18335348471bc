// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pieces with ghost layers are the picture of the whole, for every model that looks no farther; so they are with opaque
// geometry in them, and with the camera inside.

#include "PieceScenes.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

namespace
{
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
