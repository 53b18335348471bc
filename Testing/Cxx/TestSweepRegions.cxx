// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A sweep draws only the froxels of which something can come of it: the picture is that of one that draws all, as it is
// with SkipEmptySpaceOff(), to the last bit of a float.

#include "TestScene.h"
#include "vtkVisibilitySweep.h"

#include "vtkLight.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPlane.h"

#include <functional>

namespace
{
using Setting = std::function<void(TestScene&)>;

// Everywhere in the volume something hides a little, and everything looks.
void MakeFog(TestScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.02);
  scene.Opacity->AddPoint(0.4, 0.05);
  scene.Opacity->AddPoint(0.6, 0.9);
  scene.Property->OcclusionOn();
}

void ClearFog(TestScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.4, 0.0);
  scene.Opacity->AddPoint(0.6, 0.9);
}

struct Case
{
  const char* Name;
  Setting Apply;
};

void Turn(TestScene& scene)
{
  scene.Renderer->GetActiveCamera()->SetPosition(2.0, -1.6, 1.4);
  scene.Renderer->ResetCamera();
}

void ComeNear(TestScene& scene)
{
  scene.Renderer->GetActiveCamera()->SetPosition(2.0, -1.6, 1.4);
  scene.Renderer->ResetCameraClippingRange();
}

void UseParallel(TestScene& scene)
{
  Turn(scene);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.5);
}

void UseShadows(TestScene& scene)
{
  scene.Property->OcclusionOff();
  scene.Property->ShadowsOn();
  scene.Property->SetReflectanceModelToNone();
  scene.Renderer->SetAutomaticLightCreation(false);
}

void AddLight(TestScene& scene, double x, double y, double z, bool isPositional)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetPositional(isPositional);
  light->SetConeAngle(180.0);
  scene.Renderer->AddLight(light);
}

const Case Cases[] = {
  { "along an axis", [](TestScene&) {} },
  { "turned", Turn },
  { "without fog",
    [](TestScene& s) {
      Turn(s);
      ClearFog(s);
    } },
  { "a ball of glass, not gathered",
    [](TestScene& s) {
      Turn(s);
      s.Opacity->RemoveAllPoints();
      s.Opacity->AddPoint(0.5, 0.0);
      s.Opacity->AddPoint(0.52, 0.1);
      s.Optics->SetVisibilityGatherSamples(0);
      s.Optics->SetVisibilitySliceDistance(4.0);
    } },
  { "without fog, near, not gathered",
    [](TestScene& s) {
      ComeNear(s);
      ClearFog(s);
      s.Optics->SetVisibilityGatherSamples(0);
    } },
  { "without fog, a scaled and turned volume, large cells",
    [](TestScene& s) {
      ClearFog(s);
      s.Optics->SetMacrocellSize(11);
      s.Volume->SetScale(0.2, 1.0, 1.7);
      s.Volume->SetOrientation(20.0, 40.0, 60.0);
      s.Renderer->ResetCamera();
    } },
  { "without fog, shadows of a lamp in the volume",
    [](TestScene& s) {
      ClearFog(s);
      UseShadows(s);
      AddLight(s, 0.2, 0.7, 0.6, true);
    } },
  { "without fog, soft shadows",
    [](TestScene& s) {
      ClearFog(s);
      UseShadows(s);
      s.Property->SetShadowAngle(20.0);
      AddLight(s, 1.0, -2.0, 2.0, true);
      AddLight(s, 1.0, 2.0, 3.0, false);
    } },
  { "without fog, integration in data space",
    [](TestScene& s) {
      Turn(s);
      ClearFog(s);
      s.Property->SetIntegrationSpaceToData();
    } },
  { "a fog that gradient opacity hides",
    [](TestScene& s) {
      Turn(s);
      vtkNew<vtkPiecewiseFunction> function;
      function->AddPoint(0.0, 0.0);
      function->AddPoint(0.2, 0.0);
      function->AddPoint(0.3, 1.0);
      s.Property->SetGradientOpacity(function);
    } },
  { "nothing to see",
    [](TestScene& s) {
      s.Opacity->RemoveAllPoints();
      s.Opacity->AddPoint(0.0, 0.0);
      s.Opacity->AddPoint(1.0, 0.0);
    } },
  { "near", ComeNear },
  { "in parallel", UseParallel },
  { "a narrow cone",
    [](TestScene& s) {
      Turn(s);
      s.Property->SetOcclusionAngle(5.0);
    } },
  { "a cone of 80 degrees",
    [](TestScene& s) {
      Turn(s);
      s.Property->SetOcclusionAngle(80.0);
    } },
  { "not gathered",
    [](TestScene& s) {
      Turn(s);
      s.Optics->SetVisibilityGatherSamples(0);
    } },
  { "not gathered, in parallel",
    [](TestScene& s) {
      UseParallel(s);
      s.Optics->SetVisibilityGatherSamples(0);
    } },
  { "a disk",
    [](TestScene& s) {
      Turn(s);
      s.Optics->SetVisibilityAlgorithmToDisk();
      s.Property->SetOcclusionAngle(30.0);
    } },
  { "a wide view",
    [](TestScene& s) {
      s.Renderer->GetActiveCamera()->SetPosition(1.2, -0.9, 1.1);
      s.Renderer->GetActiveCamera()->SetViewAngle(110.0);
      s.Renderer->ResetCameraClippingRange();
    } },
  { "a part of the volume in the window",
    [](TestScene& s) {
      Turn(s);
      s.Renderer->GetActiveCamera()->SetViewAngle(12.0);
      s.Renderer->GetActiveCamera()->Yaw(8.0);
    } },
  { "the camera in the volume",
    [](TestScene& s) {
      s.Renderer->GetActiveCamera()->SetPosition(0.3, -0.7, 0.6);
      s.Renderer->ResetCameraClippingRange();
    } },
  { "clipped by the camera",
    [](TestScene& s) {
      Turn(s);
      s.Renderer->GetActiveCamera()->SetClippingRange(2.5, 3.2);
    } },
  { "clipped by a plane",
    [](TestScene& s) {
      Turn(s);
      vtkNew<vtkPlane> plane;
      plane->SetNormal(-0.3, 1.0, 0.2);
      s.Mapper->AddClippingPlane(plane);
    } },
  { "few froxels",
    [](TestScene& s) {
      Turn(s);
      s.Optics->SetVisibilityGridSize(5);
    } },
  { "thick slices",
    [](TestScene& s) {
      Turn(s);
      s.Optics->SetVisibilitySliceDistance(7.0);
    } },
  { "long steps",
    [](TestScene& s) {
      Turn(s);
      s.Mapper->SetSampleDistance(0.5F);
    } },
  { "a scaled and turned volume",
    [](TestScene& s) {
      s.Volume->SetScale(0.2, 1.0, 1.7);
      s.Volume->SetOrientation(20.0, 40.0, 60.0);
      s.Renderer->ResetCamera();
    } },
  { "integration in data space",
    [](TestScene& s) {
      Turn(s);
      s.Property->SetIntegrationSpaceToData();
    } },
  { "partitions",
    [](TestScene& s) {
      Turn(s);
      vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(s.Mapper)->SetPartitions(2, 1, 2);
    } },
  { "32 bits",
    [](TestScene& s) {
      Turn(s);
      s.Optics->SetVisibilityPrecision(32);
    } },
  { "shadows of a sun",
    [](TestScene& s) {
      UseShadows(s);
      AddLight(s, 1.0, 2.0, 3.0, false);
    } },
  { "soft shadows of a sun",
    [](TestScene& s) {
      UseShadows(s);
      s.Property->SetShadowAngle(20.0);
      AddLight(s, 1.0, 2.0, 3.0, false);
    } },
  { "soft shadows of a lamp",
    [](TestScene& s) {
      UseShadows(s);
      s.Property->SetShadowAngle(20.0);
      AddLight(s, 1.0, -2.0, 2.0, true);
    } },
  { "shadows of a lamp in the volume",
    [](TestScene& s) {
      UseShadows(s);
      AddLight(s, 0.2, 0.7, 0.6, true);
    } },
};

std::vector<float> Draw(TestScene& scene, const Setting& setting, bool skips)
{
  scene.Window->SetSize(60, 60);
  scene.Optics->SetVisibilityGridSize(32);
  scene.Optics->SetSkipEmptySpace(skips);
  MakeFog(scene);
  setting(scene);
  return scene.RenderFloat();
}

void CheckCase(Check& check, const Case& each)
{
  TestScene whole, part;
  const std::vector<float> expected = Draw(whole, each.Apply, false);
  check.That(Draw(part, each.Apply, true) == expected, std::string(each.Name) + ": another picture");
}

// Of a cube that is seen along its diagonal much of the grid lies in front of it, beside it and behind it.
double DrawnFraction(const Setting& setting, bool skips)
{
  TestScene scene;
  Draw(
    scene,
    [&](TestScene& s) {
      Turn(s);
      s.Property->SetOcclusionAngle(30.0);
      s.Optics->SetVisibilityGridSize(64);
      setting(s);
    },
    skips);
  return scene.Optics->GetOcclusionSweep()->GetDrawnFraction();
}

// By geometry: the ball fills a tenth of the cube.
void CheckPart(Check& check)
{
  const Setting fog = [](TestScene&) {};
  check.Near("part that is drawn, not skipping", DrawnFraction(fog, false), 1.0, 0.0);
  check.AtMost("part that is drawn of a fog", DrawnFraction(fog, true), 0.75);
  check.AtMost("part that is drawn of a ball", DrawnFraction(ClearFog, true), 0.5);
}

// What was left out is swept when it is asked for.
void CheckChange(Check& check)
{
  TestScene scene;
  const std::vector<float> part = Draw(scene, Turn, true); // a fog: the shader stays
  scene.Optics->SkipEmptySpaceOff();
  check.That(scene.RenderFloat() == part, "after a change: another picture");
  check.Near(
    "part that is drawn, after a change", scene.Optics->GetOcclusionSweep()->GetDrawnFraction(), 1.0, 0.0);
}
}

int TestSweepRegions(int, char*[])
{
  Check check;
  for (const Case& each : Cases)
  {
    CheckCase(check, each);
  }
  CheckPart(check);
  CheckChange(check);
  return check.ExitCode();
}
