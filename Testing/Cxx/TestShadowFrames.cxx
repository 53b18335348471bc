// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows in whatever draws a frame: among translucent geometry, for a selection, in two renderers, with several
// samples a pixel, in windows of any size, from within the volume; each against the same scene drawn another way.

#include "ShadowScene.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLightCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <utility>

namespace
{
// Lit from the camera's side.
struct LitScene : ShadowScene
{
  LitScene()
  {
    this->Optics->SetVisibilityGridSize(48);
    this->Window->SetSize(40, 40);
    this->AddSun(0.5, -1.0, 1.0);
  }
};

// Black, across the middle of the volume, seen from its front.
vtkSmartPointer<vtkActor> AddCurtain(LitScene& scene)
{
  vtkNew<vtkPlaneSource> curtain;
  curtain->SetOrigin(-3.0, 0.0, -3.0);
  curtain->SetPoint1(3.0, 0.0, -3.0);
  curtain->SetPoint2(-3.0, 0.0, 3.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(curtain->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  scene.Renderer->AddActor(actor);
  return actor;
}

// Of the volume, a translucent curtain leaves all in front and a part behind; an opaque one leaves what is in front,
// and, as the light comes from there, its shadows too. Translucent geometry casts no shadow.
void CheckPeeling(Check& check)
{
  LitScene scene;
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  scene.Window->SetAlphaBitPlanes(1);
  vtkSmartPointer<vtkActor> curtain = AddCurtain(scene);
  curtain->VisibilityOff();
  const std::vector<unsigned char> all = scene.Render();
  curtain->VisibilityOn();
  const std::vector<unsigned char> front = scene.Render();
  curtain->GetProperty()->SetOpacity(0.4);
  const std::vector<unsigned char> peeled = scene.Render();
  double sum = 0.0;
  double behind = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    sum += std::abs(peeled[i] - (0.6 * all[i] + 0.4 * front[i]));
    behind += all[i] - front[i];
  }
  const auto count = static_cast<double>(all.size());
  // a ray's samples begin anew behind the curtain: of a step's opacity, .36, some is there twice or not at all
  check.AtMost("peeled: mean difference", sum / count, 1.0);
  check.AtLeast("what is behind the curtain", behind / count, 5.0);
}

void CheckPicking(Check& check)
{
  LitScene scene;
  const std::vector<unsigned char> before = scene.Render();
  const int sweeps = scene.Optics->GetShadowSweepCount();
  const std::pair<unsigned int, bool> pixels[] = { { 20, true }, { 1, false } };
  for (const auto& [at, isVolume] : pixels)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetArea(at, at, at, at);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    const bool isPicked = selection && selection->GetNumberOfNodes() > 0 &&
      selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()) == scene.Volume.Get();
    check.That(isPicked == isVolume, "picking at " + std::to_string(at));
  }
  check.That(scene.Render() == before, "the picture after a selection differs");
  check.Near("sweeps of a selection", scene.Optics->GetShadowSweepCount(), sweeps, 0);
}

// Each draws as alone, and neither takes the other's shadows for its own.
void CheckRenderers(Check& check)
{
  LitScene left, right;
  right.Renderer->GetActiveCamera()->Azimuth(40.0);
  right.AddSun(-1.0, 0.0, 0.5);
  const std::vector<unsigned char> alone[2] = { left.Render(), right.Render() };
  LitScene both;
  both.Window->SetSize(80, 40);
  both.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->SetAutomaticLightCreation(false);
  other->SetActiveCamera(right.Renderer->GetActiveCamera());
  vtkCollectionSimpleIterator iterator;
  right.Renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = right.Renderer->GetLights()->GetNextLight(iterator))
  {
    other->AddLight(light);
  }
  other->AddVolume(both.Volume);
  both.Window->AddRenderer(other);
  for (int frame = 0; frame < 2; ++frame)
  {
    const std::vector<unsigned char> pixels = both.Render();
    int largest = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      const std::size_t x = i / 3 % 80, y = i / 240;
      largest = std::max(largest, std::abs(pixels[i] - alone[x / 40][3 * (40 * y + x % 40) + i % 3]));
    }
    check.Near("two renderers, frame " + std::to_string(frame), largest, 0, 0);
  }
}

// Where the volume without shadows is the same, so that no side of its box is in the pixel.
void CheckMultiSamples(Check& check)
{
  LitScene plain, several;
  several.Window->SetMultiSamples(4);
  std::vector<unsigned char> pictures[2][2];
  for (const bool hasShadows : { false, true })
  {
    plain.Property->SetShadows(hasShadows);
    several.Property->SetShadows(hasShadows);
    pictures[hasShadows ? 1 : 0][0] = plain.Render();
    pictures[hasShadows ? 1 : 0][1] = several.Render();
  }
  int largest = 0;
  int compared = 0;
  for (std::size_t i = 0; i < pictures[0][0].size(); ++i)
  {
    if (pictures[0][0][i] > 0 && pictures[0][0][i] == pictures[0][1][i])
    {
      largest = std::max(largest, std::abs(pictures[1][0][i] - pictures[1][1][i]));
      ++compared;
    }
  }
  check.AtMost("multi-sampling", largest, 1);
  check.AtLeast("pixels without a side of the box", compared, 1000);
}

void CheckWindows(Check& check)
{
  LitScene scene;
  const std::vector<unsigned char> before = scene.Render();
  for (const auto& [width, height] :
    { std::pair<int, int>(1, 1), std::pair<int, int>(1, 37), std::pair<int, int>(39, 21) })
  {
    scene.Window->SetSize(width, height);
    const std::string name = std::to_string(width) + " x " + std::to_string(height);
    const std::vector<float> pixels = scene.RenderFloat();
    check.That(AreFinite(pixels), name + ": NaN");
    scene.Property->ShadowsOff();
    const std::vector<float> lit = scene.RenderFloat();
    scene.Property->ShadowsOn();
    const int middle = 4 * (width * (height / 2) + width / 2);
    check.AtLeast(name + ": the middle without shadows", lit[middle], 0.2);
    check.AtMost(name + ": the middle with shadows", pixels[middle], 0.9 * lit[middle]);
  }
  scene.Window->SetSize(40, 40);
  check.That(scene.Render() == before, "the picture after other sizes differs");
}

// What is seen from within the volume has the shadows that are seen from outside: the floor, straight below, in the
// ball's shadow and out of it.
void CheckCameraInside(Check& check)
{
  LitScene scene;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  scene.Renderer->RemoveAllLights();
  scene.AddSun(1.0, 0.0, 1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  for (const double x : { -0.8, 0.7 }) // the ball's shadow is about -.8
  {
    double seen[2];
    for (const bool isInside : { false, true })
    {
      camera->SetPosition(x, 0.0, isInside ? -0.35 : 4.0);
      camera->SetFocalPoint(x, 0.0, -1.0);
      camera->SetViewAngle(isInside ? 4.0 : 0.5);
      scene.Renderer->ResetCameraClippingRange();
      seen[isInside ? 1 : 0] = scene.RenderFloat()[4 * (40 * 20 + 20)];
    }
    check.Near("from within at " + std::to_string(x), seen[1], seen[0], 0.02);
    x < 0.0 ? check.AtMost("in the shadow", seen[0], 0.05) : check.AtLeast("in the light", seen[0], 0.2);
  }
}
}

int TestShadowFrames(int, char*[])
{
  Check check;
  CheckPeeling(check);
  CheckPicking(check);
  CheckRenderers(check);
  CheckMultiSamples(check);
  CheckWindows(check);
  CheckCameraInside(check);
  return check.ExitCode();
}
