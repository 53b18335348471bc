// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Grids, scalars, functions and views at their ends: pixels stay finite, what cannot be drawn is left
// out, and what the user has to know is said once.

#include "TestScene.h"
#include "TetrahedraScene.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGridBunykRayCastFunction.h"

#include <algorithm>

namespace
{
const int Size = 32;
using Pixels = std::vector<float>;

double Linear(double, double, double z)
{
  return 0.5 + 0.4 * z;
}

Pixels RenderFloat(TetrahedraScene& scene)
{
  return RenderFloat(scene.Window, scene.Renderer);
}

float LargestPixel(const Pixels& pixels)
{
  float largest = 0.0F;
  for (std::size_t i = 0; i < pixels.size(); i += 4)
  {
    largest = std::max(largest, pixels[i]);
  }
  return largest;
}

float SmallestPixel(const Pixels& pixels)
{
  float smallest = 1.0F;
  for (std::size_t i = 0; i < pixels.size(); i += 4)
  {
    smallest = std::min(smallest, pixels[i]);
  }
  return smallest;
}

// Flat cells, of coincident points or in a plane, add nothing, whatever their scalars are.
void TestFlatCells(Check& check)
{
  Grid plain = MakeBox(3, Linear);
  Grid flat = MakeBox(3, Linear);
  const vtkIdType point = flat->GetPoints()->InsertNextPoint(0.1, 0.2, 0.0);
  vtkFloatArray::SafeDownCast(flat->GetPointData()->GetScalars())->InsertNextValue(0.9F);
  const vtkIdType coincident[4] = { 0, point, point, 1 }, inPlane[4] = { 0, 1, 4, 5 };
  flat->InsertNextCell(VTK_TETRA, 4, coincident);
  flat->InsertNextCell(VTK_TETRA, 4, inPlane);
  Pixels pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    TetrahedraScene scene(TetrahedraScene::Projected, i == 0 ? plain : flat, Size);
    scene.SetConstantOpacity(0.7);
    scene.Property->SetSilhouetteToExact();
    pictures[i] = RenderFloat(scene);
  }
  check.That(pictures[0] == pictures[1], "flat cells change the picture");
}

// Cells with a scalar that is no number are left out; the others are drawn.
void TestNotANumber(Check& check)
{
  for (float value : { std::nanf(""), std::numeric_limits<float>::infinity() })
  {
    Grid grid = MakeBox(4, Linear);
    vtkFloatArray::SafeDownCast(grid->GetPointData()->GetScalars())->SetValue(62, value); // the middle
    const double whole = 1.0 - std::pow(0.3, 0.8);
    TetrahedraScene scene(TetrahedraScene::Projected, grid, Size);
    scene.SetConstantOpacity(0.7);
    scene.Property->SetSilhouetteToExact();
    const Pixels pixels = RenderFloat(scene);
    check.That(AreFinite(pixels), "a pixel is not finite with a scalar of " + std::to_string(value));
    check.Near("corner", pixels[0], whole, 1e-4);
    check.AtMost("behind what is left out", pixels[4 * (Size / 2 * Size + Size / 2)], whole - 0.1);
    TetrahedraScene cast(TetrahedraScene::RayCast, grid, Size);
    cast.SetConstantOpacity(0.7);
    check.Near("ray caster, corner", cast.RenderOpacity(3, 3), whole, 1.0 / 255.0);
    check.AtMost("ray caster, middle", cast.RenderOpacity(Size / 2, Size / 2), whole - 0.1);
  }
}

void TestConstantCells(Check& check)
{
  for (TetrahedraScene::Kind kind : { TetrahedraScene::Projected, TetrahedraScene::RayCast })
  {
    Grid constant = MakeBox(2, [](double, double, double) { return 0.3; });
    TetrahedraScene scene(kind, constant, Size);
    scene.SetConstantOpacity(1.0);
    scene.Property->AddIsosurface(0.3, 1.0, 1.0, 1.0, 1.0);
    const std::vector<unsigned char> picture = scene.Render();
    check.AtMost("constant scalars", *std::max_element(picture.begin(), picture.end()), 0);

    Grid half = MakeBox(2, [](double, double, double z) { return std::max(z, 0.0); });
    TetrahedraScene other(kind, half, Size);
    other.SetConstantOpacity(0.7);
    check.Near("half constant", other.RenderOpacity(9, 20), 0.7, 1.0 / 255.0);
  }
}

// Opacity 1, steps and coincident nodes, the smallest and largest table, unit intervals of 1e-30, 1e30.
void TestFunctions(Check& check)
{
  Grid grid = MakeBox(4, [](double x, double y, double z) { return x * y * z; });
  const std::pair<const char*, std::function<void(TetrahedraScene&)>> cases[] = {
    { "opaque", [](TetrahedraScene& scene) { scene.SetConstantOpacity(1.0); } },
    { "transparent", [](TetrahedraScene& scene) { scene.SetConstantOpacity(0.0); } },
    { "coincident nodes",
      [](TetrahedraScene& scene) {
        scene.Opacity->AllowDuplicateScalarsOn();
        scene.Opacity->AddPoint(0.1, 0.0);
        scene.Opacity->AddPoint(0.1, 1.0);
        scene.Color->AllowDuplicateScalarsOn();
        scene.Color->AddRGBPoint(0.1, 0.0, 0.0, 0.0);
        scene.Color->AddRGBPoint(0.1, 1.0, 1.0, 1.0);
      } },
    { "small unit", [](TetrahedraScene& scene) { scene.Property->SetScalarOpacityUnitInterval(1e-30); } },
    { "large unit", [](TetrahedraScene& scene) { scene.Property->SetScalarOpacityUnitInterval(1e30); } },
    { "table of 2", [](TetrahedraScene& scene) { scene.Tetrahedra->SetTableSize(2); } },
    { "table of 1024", [](TetrahedraScene& scene) { scene.Tetrahedra->SetTableSize(1024); } },
  };
  for (const auto& [name, apply] : cases)
  {
    for (int mode = 0; mode < 4; ++mode)
    {
      TetrahedraScene scene(TetrahedraScene::Projected, grid, Size);
      scene.SetConstantOpacity(0.7);
      scene.Property->AddIsosurface(0.0, 1.0, 1.0, 1.0, 1.0);
      scene.Property->SetSilhouette(mode);
      apply(scene);
      const Pixels pixels = RenderFloat(scene);
      check.That(AreFinite(pixels), std::string("a pixel is not finite: ") + name);
      check.AtMost(std::string("largest pixel: ") + name, LargestPixel(pixels), 1.0 + 1e-6);
    }
  }
  TetrahedraScene opaque(TetrahedraScene::Projected, MakeBox(2, Linear), Size);
  opaque.SetConstantOpacity(1.0);
  check.Near("opaque", SmallestPixel(RenderFloat(opaque)), 1.0, 0.0);
}

// The half in front of an opaque plane is seen; a camera in the middle sees the half in front of it; a
// mirrored volume is the same.
void TestViews(Check& check)
{
  Grid grid = MakeBox(3, Linear);
  const double half = 1.0 - std::pow(0.3, 0.4), whole = 1.0 - std::pow(0.3, 0.8);
  TetrahedraScene scene(TetrahedraScene::Projected, grid, Size);
  scene.SetConstantOpacity(0.7);
  scene.Volume->SetScale(-1.0, 1.0, 1.0);
  check.Near("mirrored", SmallestPixel(RenderFloat(scene)), whole, 2e-5);
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 0.001);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -1.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.001, 5.0);
  check.Near("inside", SmallestPixel(RenderFloat(scene)), half, 2e-5);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  check.Near("inside, perspective", SmallestPixel(RenderFloat(scene)), half, 2e-5);

  for (bool isParallel : { true, false })
  {
    TetrahedraScene cut(TetrahedraScene::Projected, grid, Size);
    cut.SetConstantOpacity(0.7);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-3.0, -3.0, 0.0);
    plane->SetPoint1(3.0, -3.0, 0.0);
    plane->SetPoint2(-3.0, 3.0, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
    cut.Renderer->AddActor(actor);
    cut.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
    cut.Renderer->GetActiveCamera()->SetViewAngle(15.0);
    // the plane's depth has 24 bits over a range of some lengths
    const std::vector<unsigned char> pixels = cut.Render();
    const double opacity = pixels[3 * (Size / 2 * Size + Size / 2)] / 255.0;
    check.Near("in front of a plane", opacity, half, 1.0 / 255.0);
  }
}

void TestSaidOnce(Check& check, const std::string& what, vtkObject* speaker, TetrahedraScene& scene,
  const std::string& remedy)
{
  const Warnings warnings(speaker);
  scene.Render();
  scene.Volume->Modified();
  const std::vector<unsigned char> picture = scene.Render();
  check.Near("messages of " + what, static_cast<double>(warnings.Texts.size()), 1.0, 0.0);
  check.That(!warnings.Texts.empty() && warnings.Texts[0].find(remedy) != std::string::npos,
    what + " does not name " + remedy);
}

void TestMessages(Check& check)
{
  Grid bare = MakeBox(2, Linear);
  bare->GetPointData()->Initialize();
  TetrahedraScene without(TetrahedraScene::Projected, bare, Size);
  TestSaidOnce(check, "no scalars", without.Tetrahedra, without, "SelectScalarArray");

  Grid mixed = MakeBox(2, Linear);
  const vtkIdType ids[5] = { 0, 1, 2, 3, 4 };
  mixed->InsertNextCell(VTK_PYRAMID, 5, ids);
  TetrahedraScene pyramid(TetrahedraScene::Projected, mixed, Size);
  pyramid.SetConstantOpacity(0.7);
  TestSaidOnce(check, "another cell", pyramid.Tetrahedra, pyramid, "vtkDataSetTriangleFilter");
  check.Near("picture of another cell", pyramid.RenderOpacity(9, 9), 0.0, 0.0);

  Grid cells = MakeBox(2, Linear);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i));
  }
  cells->GetPointData()->Initialize();
  cells->GetCellData()->SetScalars(values);
  TetrahedraScene ofCells(TetrahedraScene::Projected, cells, Size);
  TestSaidOnce(check, "cell scalars", ofCells.Tetrahedra, ofCells, "vtkCellDataToPointData");
  TetrahedraScene castCells(TetrahedraScene::RayCast, cells, Size);
  TestSaidOnce(check, "cell scalars, ray caster", castCells.Integrator, castCells, "vtkCellDataToPointData");
  check.Near("picture of cell scalars", castCells.RenderOpacity(9, 9), 0.0, 0.0);

  Grid vectors = MakeBox(2, Linear);
  vtkNew<vtkFloatArray> pairs;
  pairs->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < vectors->GetNumberOfPoints(); ++i)
  {
    pairs->InsertNextTuple2(Linear(0.0, 0.0, vectors->GetPoint(i)[2]), 7.0);
  }
  vectors->GetPointData()->SetScalars(pairs);
  for (TetrahedraScene::Kind kind : { TetrahedraScene::Projected, TetrahedraScene::RayCast })
  {
    TetrahedraScene scene(kind, vectors, Size);
    scene.SetConstantOpacity(0.7);
    vtkObject* speaker = scene.Integrator;
    TestSaidOnce(check, "two components", kind == TetrahedraScene::Projected ? scene.Tetrahedra : speaker,
      scene, "the first is drawn");
    check.Near("first component", scene.RenderOpacity(9, 9), 1.0 - std::pow(0.3, 0.8), 1.0 / 255.0);
  }

  TetrahedraScene silhouette(TetrahedraScene::RayCast, MakeBox(2, Linear), Size);
  silhouette.Ray->SetRayCastFunction(vtkSmartPointer<vtkUnstructuredGridBunykRayCastFunction>::New());
  silhouette.SetConstantOpacity(0.7);
  silhouette.Property->SetSilhouetteToExact();
  TestSaidOnce(check, "silhouettes", silhouette.Integrator, silhouette, "vtkDataSpaceRayCastFunction");
  check.Near("without silhouettes", silhouette.RenderOpacity(9, 9), 1.0 - std::pow(0.3, 0.8), 1.0 / 255.0);

  TetrahedraScene many(TetrahedraScene::Projected, MakeBox(2, Linear), Size);
  for (int i = 0; i < 1025; ++i)
  {
    many.Property->AddIsosurface(0.5 + 1e-4 * i, 1.0, 1.0, 1.0, 0.01);
  }
  TestSaidOnce(check, "too many isosurfaces", many.Tetrahedra, many, "RemoveIsosurface");

  TetrahedraScene empty(TetrahedraScene::Projected, Grid::New(), Size);
  const Warnings warnings(empty.Tetrahedra);
  check.Near("empty grid", empty.RenderOpacity(9, 9), 0.0, 0.0);
  check.That(warnings.Texts.empty(), "an empty grid is no reason for a message");
}

// Ghosts and blanked cells are left out: here all but the lower half, which alone is seen.
void TestHiddenCells(Check& check)
{
  Grid grid = MakeBox(4, Linear);
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    grid->GetCellBounds(i, bounds);
    const int kinds[2] = { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL };
    hidden->InsertNextValue(static_cast<unsigned char>(bounds[5] > 0.01 ? kinds[i % 2] : 0));
  }
  grid->GetCellData()->AddArray(hidden);
  TetrahedraScene scene(TetrahedraScene::Projected, grid, Size);
  scene.SetConstantOpacity(0.7);
  check.Near("below hidden cells", SmallestPixel(RenderFloat(scene)), 1.0 - std::pow(0.3, 0.4), 2e-5);
}

// Everything that is uploaded follows its source, also into another window.
void TestChanges(Check& check)
{
  Grid grid = MakeBox(2, Linear);
  TetrahedraScene scene(TetrahedraScene::Projected, grid, Size);
  scene.SetConstantOpacity(0.7);
  const double unit = 1.0 / 255.0;
  check.Near("first", scene.RenderOpacity(9, 9), 1.0 - std::pow(0.3, 0.8), unit);
  SetScalars(grid, [](double, double, double z) { return 0.5 + 0.2 * z; });
  check.Near("other scalars", scene.RenderOpacity(9, 9), 1.0 - std::pow(0.3, 0.4), unit);
  scene.SetConstantOpacity(0.5);
  check.Near("other opacity", scene.RenderOpacity(9, 9), 1.0 - std::pow(0.5, 0.4), unit);
  scene.Window->SetSize(Size + 7, Size - 5);
  check.Near("other size", scene.RenderOpacity(19, 9), 1.0 - std::pow(0.5, 0.4), unit);
  scene.Window->RemoveRenderer(scene.Renderer);
  scene.Window = vtkSmartPointer<vtkRenderWindow>::New();
  scene.Window->SetMultiSamples(0);
  scene.Window->SetSize(Size, Size);
  scene.Window->AddRenderer(scene.Renderer);
  check.Near("other window", scene.RenderOpacity(9, 9), 1.0 - std::pow(0.5, 0.4), unit);
}
}

int TestTetrahedraExtremes(int, char*[])
{
  Check check;
  TestFlatCells(check);
  TestNotANumber(check);
  TestConstantCells(check);
  TestFunctions(check);
  TestViews(check);
  TestMessages(check);
  TestHiddenCells(check);
  TestChanges(check);
  return check.ExitCode();
}
