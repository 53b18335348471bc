// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Selecting a volume that a term draws: the pixel tells the volume, and the picture comes back.

#include "TestScene.h"

#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace
{
vtkObjectBase* PropAt(vtkRenderer* renderer, unsigned int x, unsigned int y)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(x, y, x, y);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    return nullptr;
  }
  return selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP());
}

void TestReflectance(Check& check)
{
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  const std::vector<unsigned char> before = scene.Render();
  check.That(PropAt(scene.Renderer, 75, 75) == scene.Volume.Get(), "the centre is not the volume");
  check.That(PropAt(scene.Renderer, 2, 2) == nullptr, "the corner is not empty");
  check.That(scene.Render() == before, "the picture after a selection differs");
}

// Nothing but an isosurface is seen: the opacity function is zero everywhere.
void TestIsosurface(Check& check)
{
  TestScene scene;
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(1.0, 0.0);
  scene.Property->SetIntegrationSpaceToData();
  const int surface = scene.Property->AddIsosurface(0.5, 0.4);
  const std::vector<unsigned char> before = scene.Render();
  check.That(PropAt(scene.Renderer, 75, 75) == scene.Volume.Get(), "the isosurface is not picked");
  check.That(PropAt(scene.Renderer, 2, 2) == nullptr, "the corner beside the isosurface is not empty");
  check.That(scene.Render() == before, "the picture after a selection of the isosurface differs");
  scene.Property->RemoveIsosurface(surface);
  check.That(PropAt(scene.Renderer, 75, 75) == nullptr, "a removed isosurface is picked");
}
}

int TestPicking(int, char*[])
{
  Check check;
  TestReflectance(check);
  TestIsosurface(check);
  return check.ExitCode();
}
