// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Selecting a volume that a term draws: the pixel tells the volume, and the picture comes back.

#include "RayCaster.h"
#include "TestScene.h"

#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkVolumePicker.h"

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

// VTK's picker on the CPU knows the opacity function alone: a volume that is not drawn has a ramp for it.
void TestPointOnIsosurface(Check& check)
{
  TestScene scene;
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(1.0, 0.0);
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->AddIsosurface(0.4, 1.0);
  scene.Render();
  vtkNew<vtkVolumePicker> picker;
  check.That(picker->Pick(75.0, 75.0, 0.0, scene.Renderer) == 0,
    "VTK's picker finds isosurfaces: tell docs/support.md");

  vtkNew<vtkPiecewiseFunction> ramp;
  ramp->AddPoint(-0.1, 0.0);
  ramp->AddPoint(0.9, 1.0);
  vtkNew<vtkVolumeProperty> property;
  property->SetScalarOpacity(ramp);
  property->SetInterpolationTypeToLinear();
  vtkNew<vtkVolume> picked;
  picked->SetMapper(scene.Mapper);
  picked->SetProperty(property);
  picker->PickFromListOn();
  picker->AddPickList(picked);
  picker->SetVolumeOpacityIsovalue(0.5);
  check.That(picker->Pick(75.0, 75.0, 0.0, scene.Renderer) == 1, "no point on the isosurface is picked");
  const double* place = picker->GetPickPosition();
  const reference::Scene seen = reference::SceneFromVTK(scene.Renderer, scene.Volume, 150, 150);
  const double scalar = seen.field->Value(reference::Vector(place[0], place[1], place[2]));
  check.Near(
    "scalar at the picked point", scalar, 0.4, 0.01); // the picker is linear between planes of voxels
}
}

int TestPicking(int, char*[])
{
  Check check;
  TestReflectance(check);
  TestIsosurface(check);
  TestPointOnIsosurface(check);
  return check.ExitCode();
}
