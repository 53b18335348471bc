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
}

int TestPicking(int, char*[])
{
  Check check;
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  const std::vector<unsigned char> before = scene.Render();
  check.That(PropAt(scene.Renderer, 75, 75) == scene.Volume.Get(), "the centre is not the volume");
  check.That(PropAt(scene.Renderer, 2, 2) == nullptr, "the corner is not empty");
  check.That(scene.Render() == before, "the picture after a selection differs");
  return check.ExitCode();
}
