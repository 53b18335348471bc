// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Occlusion of one scene, a pane of glass above a white floor, in ways of VTK's that must not matter to it: as a label,
// by a 2D function, in cells, of unequal spacing, among translucent geometry; and of a picture that was picked in.

#include "OcclusionTesting.h"
#include "vtkVisibilitySweep.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace
{
const double GlassOpacity = 0.05;

double Pane(double, double, double z)
{
  return z < FloorHeight ? Dense : (std::abs(z + 0.1) < 0.12 ? Glass : 0.0);
}

// Two such scenes, with the pane and without.
struct PaneScenes
{
  PaneScenes()
  {
    for (OcclusionScene* scene : { &this->Open, &this->Closed })
    {
      scene->Optics->SetVisibilityGridSize(64);
      scene->Window->SetSize(17, 17);
    }
  }

  void Apply(const std::function<void(OcclusionScene&)>& change)
  {
    change(this->Open);
    change(this->Closed);
  }

  // What the pane leaves.
  double Share() { return this->Closed.Visibility() / this->Open.Visibility(); }

  OcclusionScene Open{ Floor, GlassOpacity };
  OcclusionScene Closed{ Pane, GlassOpacity };
};

vtkImageData* ImageOf(OcclusionScene& scene)
{
  return vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
}

// A label whose own function is empty takes the pane away; VTK takes labels' opacities for those of a step.
void LabelThePane(OcclusionScene& scene)
{
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(ImageOf(scene));
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
  {
    static_cast<unsigned char*>(mask->GetScalarPointer())[i] = mask->GetPoint(i)[2] > -0.3 ? 1 : 0;
  }
  scene.Mapper->SetMaskInput(mask);
  scene.Mapper->SetMaskTypeToLabelMap();
  vtkNew<vtkPiecewiseFunction> none;
  none->AddPoint(0.0, 0.0);
  none->AddPoint(1.0, 0.0);
  scene.Property->SetLabelScalarOpacity(1, none);
  scene.Property->SetLabelColor(1, scene.Color);
}

// The functions of the scalar as a table that does not ask for the gradient, of a step's opacities, as VTK takes them.
void TabulateIn2D(OcclusionScene& scene)
{
  const int size = 512;
  const double steps = scene.Mapper->GetSampleDistance() / scene.Property->GetScalarOpacityUnitDistance();
  vtkNew<vtkImageData> table;
  table->SetDimensions(size, 2, 1);
  table->AllocateScalars(VTK_FLOAT, 4);
  for (int x = 0; x < size; ++x)
  {
    const double scalar = (x + 0.5) / size;
    for (int y = 0; y < 2; ++y)
    {
      auto* texel = static_cast<float*>(table->GetScalarPointer(x, y, 0));
      double rgb[3];
      scene.Color->GetColor(scalar, rgb);
      std::copy(rgb, rgb + 3, texel);
      texel[3] = static_cast<float>(1.0 - std::pow(1.0 - scene.Opacity->GetValue(scalar), steps));
    }
  }
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(table);
}

// The same values, each in the middle of a cell.
void UseCells(OcclusionScene& scene)
{
  vtkImageData* points = ImageOf(scene);
  vtkNew<vtkImageData> cells;
  const int* size = points->GetDimensions();
  const double* spacing = points->GetSpacing();
  const double* origin = points->GetOrigin();
  cells->SetDimensions(size[0] + 1, size[1] + 1, size[2] + 1);
  cells->SetSpacing(points->GetSpacing());
  cells->SetOrigin(origin[0] - 0.5 * spacing[0], origin[1] - 0.5 * spacing[1], origin[2] - 0.5 * spacing[2]);
  cells->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  scene.Mapper->SetInputData(cells);
}

// As many points along each axis, the same values at the same heights; wider than high.
void Stretch(OcclusionScene& scene)
{
  vtkImageData* image = ImageOf(scene);
  image->SetSpacing(3.0 / 16.0, 0.7 / 16.0, 1.0 / 32.0);
  image->SetOrigin(-6.0, -1.4, -0.5);
}

void CheckSameShares(Check& check)
{
  PaneScenes plain;
  const double share = plain.Share();
  check.Near("the pane lets a part of the light through", share, 0.45, 0.2);

  PaneScenes label;
  label.Apply(LabelThePane);
  check.Near("a pane with an empty label", label.Share(), 1.0, 1.0e-3);
  check.AtLeast("its floor", label.Closed.Visibility(), 0.35);

  PaneScenes ungathered; // as with 2D functions in any case
  ungathered.Apply([](OcclusionScene& scene) { scene.Optics->SetVisibilityGatherSamples(0); });
  PaneScenes table;
  table.Apply(TabulateIn2D);
  check.Near(
    "2D function", table.Share(), ungathered.Share(), 0.01); // the table is linear between its entries
  check.Near("gathered", share, ungathered.Share(), 0.02);

  PaneScenes cells;
  cells.Apply(UseCells);
  check.Near("cell data", cells.Share(), share, 0.02); // half a voxel nearer to the eye, slices lie elsewhere

  PaneScenes stretched;
  stretched.Apply(Stretch);
  check.Near("unequal spacing", stretched.Share(), share, 0.03); // of larger froxels
}

// Translucent and black, it takes its share of the white floor's light, wherever it is; occlusion is as without it.
void CheckPeeling(Check& check)
{
  for (const double height : { 0.7, 0.2, -0.15 })
  {
    OcclusionScene scene(Pane, GlassOpacity, 17);
    scene.Optics->SetVisibilityGridSize(64);
    scene.Renderer->UseDepthPeelingOn();
    scene.Renderer->UseDepthPeelingForVolumesOn();
    scene.Window->SetAlphaBitPlanes(1);
    vtkNew<vtkPlaneSource> curtain;
    curtain->SetOrigin(-3.0, -3.0, height);
    curtain->SetPoint1(3.0, -3.0, height);
    curtain->SetPoint2(-3.0, 3.0, height);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(curtain->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
    actor->GetProperty()->SetOpacity(0.4);
    scene.Property->OcclusionOn();
    const int middle = 3 * (17 * 8 + 8);
    const double without = scene.Render()[middle];
    scene.Renderer->AddActor(actor);
    const double with = scene.Render()[middle];
    check.AtLeast("the floor", without, 20.0);
    check.Near("the floor under a curtain at " + std::to_string(height), with, 0.6 * without, 1.5);
  }
}

void CheckPicking(Check& check)
{
  OcclusionScene scene(Pane, GlassOpacity, 17);
  scene.Optics->SetVisibilityGridSize(32);
  scene.Property->OcclusionOn();
  const std::vector<unsigned char> before = scene.Render();
  const int sweeps = scene.Optics->GetOcclusionSweep()->GetSweepCount();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(8, 8, 8, 8);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  check.That(selection && selection->GetNumberOfNodes() > 0 &&
      selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()) == scene.Volume.Get(),
    "the volume is not picked");
  check.That(scene.Render() == before, "the picture after a selection differs");
  check.Near("sweeps of a selection", scene.Optics->GetOcclusionSweep()->GetSweepCount(), sweeps, 0);
}
}

int TestOcclusionEquivalents(int, char*[])
{
  Check check;
  CheckSameShares(check);
  CheckPeeling(check);
  CheckPicking(check);
  return check.ExitCode();
}
