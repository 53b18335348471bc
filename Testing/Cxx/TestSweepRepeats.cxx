// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// When a sweep is done again: the eye's where the camera or what hides light has changed, a light's where the light or
// what hides it has, and neither for anything else. And what is
// not done again is as it would be if it were.

#include "SmallScene.h"
#include "vtkVisibilitySweep.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"

#include <functional>

namespace
{
// Lit from above and from the camera's side, with shadows and occlusion.
struct SweptScene : SmallScene
{
  SweptScene()
  {
    this->Window->SetSize(24, 24);
    this->Source->SetDimensions(20, 20, 20);
    this->Optics->SetVisibilityGridSize(24);
    this->Property->SetReflectanceModelToBlinnPhong();
    this->Property->SetAmbient(0.5);
    this->Property->OcclusionOn();
    this->Property->ShadowsOn();
    this->Renderer->SetAutomaticLightCreation(false);
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetPosition(0.0, 0.5, 1.0);
    this->Renderer->AddLight(this->Sun);
    this->Lamp->SetLightTypeToSceneLight();
    this->Lamp->SetPositional(true);
    this->Lamp->SetConeAngle(180.0);
    this->Lamp->SetPosition(3.0, 0.0, 2.0);
    this->Renderer->AddLight(this->Lamp);
    this->Plane->SetOrigin(0.0, 0.0, 0.4);
    this->Plane->SetNormal(0.0, 0.0, -1.0);
    this->Mapper->AddClippingPlane(this->Plane);
  }

  vtkNew<vtkLight> Sun, Lamp;
  vtkNew<vtkPlane> Plane;
};

struct Change
{
  const char* Name;
  std::function<void(SweptScene&)> Apply;
  int Eye;    // sweeps that it asks for
  int Lights; // of two
};

// Half as dense in one half, so that no turn takes the volume to itself.
void MakeLopsided(SweptScene& scene)
{
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.Source->GetOutput());
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, scalars->GetComponent(i, 0) * (image->GetPoint(i)[0] > 0.0 ? 0.6 : 1.0));
  }
  scene.Mapper->SetInputData(image);
}

void AddPlate(SweptScene& scene)
{
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(0.0, -0.5, 1.5);
  plate->SetPoint1(0.5, -0.5, 1.5);
  plate->SetPoint2(0.0, 0.5, 1.5);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plate->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

void SetMask(SweptScene& scene)
{
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput()));
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  mask->GetPointData()->GetScalars()->Fill(255.0);
  scene.Mapper->SetMaskTypeToBinary();
  scene.Mapper->SetMaskInput(mask);
}

void HalfTurn(SweptScene& scene)
{
  vtkNew<vtkMatrix4x4> turn;
  turn->SetElement(0, 0, -1.0);
  turn->SetElement(1, 1, -1.0);
  scene.Volume->SetUserMatrix(turn);
}

void SetGradientOpacity(SweptScene& scene)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.2);
  function->AddPoint(0.1, 1.0);
  scene.Property->SetGradientOpacity(function);
}

const std::vector<Change> Nothing = {
  { "another frame", [](SweptScene&) {}, 0, 0 },
  { "Ambient", [](SweptScene& s) { s.Property->SetAmbient(0.6); }, 0, 0 },
  { "AmbientColor", [](SweptScene& s) { s.Property->SetAmbientColor(0.9, 0.9, 1.0); }, 0, 0 },
  { "Diffuse", [](SweptScene& s) { s.Property->SetDiffuse(0.5); }, 0, 0 },
  { "Specular", [](SweptScene& s) { s.Property->SetSpecular(0.5); }, 0, 0 },
  { "Glossiness", [](SweptScene& s) { s.Property->SetGlossiness(0.3); }, 0, 0 },
  { "AnisotropyScale",
    [](SweptScene& s) { s.Property->SetAnisotropyScale(vtkOpticsVolumeProperty::Ward, 5.0); }, 0, 0 },
  { "a colour", [](SweptScene& s) { s.Color->AddRGBPoint(0.5, 1.0, 0.0, 0.0); }, 0, 0 },
  { "another colour function",
    [](SweptScene& s) {
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(0.5, 0.0, 1.0, 0.0);
      s.Property->SetColor(color);
    },
    0, 0 },
  { "a light's colour", [](SweptScene& s) { s.Sun->SetDiffuseColor(1.0, 0.9, 0.8); }, 0, 0 },
  { "a light's intensity", [](SweptScene& s) { s.Sun->SetIntensity(0.7); }, 0, 0 },
  { "a light's share in the shadow", [](SweptScene& s) { s.Sun->SetShadowAttenuation(0.5F); }, 0, 0 },
  { "the background", [](SweptScene& s) { s.Renderer->SetBackground(1.0, 1.0, 1.0); }, 0, 0 },
};

const std::vector<Change> Something = {
  { "the camera", [](SweptScene& s) { s.Renderer->GetActiveCamera()->Azimuth(5.0); }, 1, 0 },
  { "the angle of view", [](SweptScene& s) { s.Renderer->GetActiveCamera()->SetViewAngle(20.0); }, 1, 0 },
  { "the cone's angle", [](SweptScene& s) { s.Property->SetOcclusionAngle(40.0); }, 1, 0 },
  { "the sun's direction", [](SweptScene& s) { s.Sun->SetPosition(0.5, 0.5, 1.0); }, 0, 1 },
  { "the lamp's place", [](SweptScene& s) { s.Lamp->SetPosition(3.0, 1.0, 2.0); }, 0, 1 },
  { "an opacity", [](SweptScene& s) { s.Opacity->AddPoint(0.6, 0.5); }, 1, 2 },
  { "another opacity function",
    [](SweptScene& s) {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.3, 0.0);
      opacity->AddPoint(0.6, 0.9);
      s.Property->SetScalarOpacity(opacity);
    },
    1, 2 },
  { "the opacity's distance", [](SweptScene& s) { s.Property->SetScalarOpacityUnitDistance(0.2); }, 1, 2 },
  { "interpolation", [](SweptScene& s) { s.Property->SetInterpolationTypeToNearest(); }, 1, 2 },
  { "data", [](SweptScene& s) { s.Source->SetDimensions(18, 18, 18); }, 1, 2 },
  { "other data", MakeLopsided, 1, 2 },
  { "half a turn, after which the box is where it was", HalfTurn, 1, 2 },
  { "a mask", SetMask, 1, 2 },
  { "the mask's values",
    [](SweptScene& s) {
      s.Mapper->GetMaskInput()->GetPointData()->GetScalars()->SetComponent(3000, 0, 0.0);
      s.Mapper->GetMaskInput()->GetPointData()->GetScalars()->Modified();
      s.Mapper->GetMaskInput()->Modified();
    },
    1, 2 },
  { "a clipping plane", [](SweptScene& s) { s.Plane->SetOrigin(0.0, 0.0, 0.2); }, 1, 2 },
  { "cropping",
    [](SweptScene& s) {
      s.Mapper->SetCroppingRegionPlanes(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
      s.Mapper->CroppingOn();
    },
    1, 2 },
  { "its planes", [](SweptScene& s) { s.Mapper->SetCroppingRegionPlanes(-0.4, 0.4, -0.4, 0.4, -0.4, 0.4); },
    1, 2 },
  { "gradient opacity", SetGradientOpacity, 1, 2 },
  { "the gradient opacity's function",
    [](SweptScene& s) { s.Property->GetGradientOpacity()->AddPoint(0.05, 0.1); }, 1, 2 },
  { "the range of opacities",
    [](SweptScene& s) { s.Mapper->SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper::NATIVE); }, 1, 2 },
  { "opaque geometry", AddPlate, 0, 2 },
  { "the froxels", [](SweptScene& s) { s.Optics->SetVisibilityGridSize(20); }, 1, 2 },
  { "the lights' angle", [](SweptScene& s) { s.Property->SetShadowAngle(10.0); }, 0, 2 },
};

// The picture after sweeps that are done in any case, as those of another grid are.
std::vector<unsigned char> SweptAnew(SweptScene& scene)
{
  const int size = scene.Optics->GetVisibilityGridSize();
  scene.Optics->SetVisibilityGridSize(4);
  scene.Render();
  scene.Optics->SetVisibilityGridSize(size);
  return scene.Render();
}

std::vector<unsigned char> CheckChange(Check& check, SweptScene& scene, const Change& change)
{
  const int eye = scene.Optics->GetOcclusionSweep()->GetSweepCount();
  const int lights = scene.Optics->GetShadowSweepCount();
  change.Apply(scene);
  std::vector<unsigned char> pixels = scene.Render();
  const std::string name = change.Name;
  check.Near(
    name + ": sweeps from the eye", scene.Optics->GetOcclusionSweep()->GetSweepCount() - eye, change.Eye, 0);
  check.Near(name + ": sweeps from lights", scene.Optics->GetShadowSweepCount() - lights, change.Lights, 0);
  return pixels;
}

void CheckChanges(Check& check, SweptScene& scene)
{
  std::vector<unsigned char> pixels;
  for (const Change& change : Nothing)
  {
    pixels = CheckChange(check, scene, change);
  }
  check.Near("against sweeps anew", LargestDifference(pixels, SweptAnew(scene)), 0, 0);
  check.Near("links", scene.Optics->GetOcclusionSweep()->GetProgramLinkCount(), 1, 0);
  for (const Change& change : Something)
  {
    pixels = CheckChange(check, scene, change);
    check.Near(
      std::string(change.Name) + ": against sweeps anew", LargestDifference(pixels, SweptAnew(scene)), 0, 0);
  }
}
}

int TestSweepRepeats(int, char*[])
{
  Check check;
  SweptScene scene;
  scene.Render();
  scene.Render(); // VTK's property has a gradient opacity once its mapper has asked for one
  CheckChanges(check, scene);
  return check.ExitCode();
}
