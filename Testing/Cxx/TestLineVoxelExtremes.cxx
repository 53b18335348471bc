// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines, grids and settings at their extremes: nothing that is not finite comes out, what is left out is said
// once, an abort leaves an empty output.

#include "LineTesting.h"
#include "Optics.h"

#include "vtkAnalyticLineSource.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"

#include <chrono>
#include <limits>

namespace
{
const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

bool IsFinite(vtkImageData* voxels)
{
  vtkDataArray* values = voxels->GetFieldData()->GetArray("LineType0_Coefficients");
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(values->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

void CheckPoints(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  lines::Messages messages(voxelizer);
  voxelizer->SetSampleDimensions(4, 4, 4);
  voxelizer->SetInputData(lines::MakeLines({ { { 0.5, 0.5, 0.5 } }, { { 0.1, 0.1, 0.1 }, { 0.1, 0.1, 0.1 } },
    { { 0.2, 0.2, 0.2 }, { 0.2, 0.2, 0.2 }, { 0.9, 0.2, 0.2 }, { 0.9, 0.2, 0.2 } }, {} }));
  voxelizer->SetModelBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0);
  voxelizer->Update();
  check.That(messages.Texts.empty(), "points alone and twice are no fault");
  check.Near("voxels of one line", lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"), 4.0, 0.0);

  voxelizer->SetInputData(
    lines::MakeLines({ { { 0.2, 0.2, 0.2 }, { NotANumber, 0.2, 0.2 }, { 0.9, 0.2, 0.2 } },
      { { 0.1, Infinity, 0.1 }, { 0.2, 0.2, 0.2 } }, { { 0.2, 0.2, 0.2 }, { 0.9, 0.2, 0.2 } } }));
  voxelizer->SetModelBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  voxelizer->Update();
  check.That(messages.Has("3 have a point"), "points that are no number are counted in one warning");
  check.That(IsFinite(voxelizer->GetOutput()), "finite");
  check.Near(
    "the finite line's voxels", lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"), 4.0, 0.0);
}

void CheckEmpty(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetSampleDimensions(9, 9, 9);
  for (bool outside : { false, true })
  {
    const auto far = lines::MakeLines({ { { 5.0, 5.0, 5.0 }, { 6.0, 6.0, 6.0 } } });
    voxelizer->SetInputData(outside ? far : lines::MakeLines({}));
    voxelizer->SetModelBounds(0.0, outside ? 1.0 : -1.0, 0.0, 1.0, 0.0, 1.0);
    vtkNew<vtkCamera> camera;
    vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
    evaluator->SetCamera(camera);
    evaluator->SetInputConnection(voxelizer->GetOutputPort());
    evaluator->Update();
    check.Near("voxels", lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"), 0.0, 0.0);
    check.Near("points", evaluator->GetOutput()->GetNumberOfPoints(), 729.0, 0.0);
    check.Near("opacity", evaluator->GetOutput()->GetPointData()->GetScalars()->GetRange(3)[1], 0.0, 0.0);
  }
}

// Ten million segments in one voxel, as a polyline that goes to and fro: the sums are exact to float.
void CheckManyInOneVoxel(Check& check)
{
  const vtkIdType portion = 1000000;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(2);
  points->SetPoint(0, 0.3, 0.4, 0.5);
  points->SetPoint(1, 0.6, 0.5, 0.45);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(portion + 1));
  for (vtkIdType i = 0; i <= portion; ++i)
  {
    cells->InsertCellPoint(i % 2);
  }
  vtkNew<vtkPolyData> many;
  many->SetPoints(points);
  many->SetLines(cells);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  lines::SetUnitVoxel(voxelizer);
  voxelizer->SetRadius(1e-3);
  voxelizer->SetMaximumOrder(2);
  voxelizer->SetInputData(lines::MakeLines({ { { 0.3, 0.4, 0.5 }, { 0.6, 0.5, 0.45 } } }));
  const glm::dvec3 toViewer(0.0, 1.0, 0.0);
  voxelizer->Update();
  const double one = lines::Look(voxelizer->GetOutput(), toViewer).Depth;
  voxelizer->SetInputData(many);
  voxelizer->SetNumberOfPieces(10); // the source gives all of it each time
  voxelizer->Update();
  const auto voxel = lines::Look(voxelizer->GetOutput(), toViewer);
  check.Near("depth of ten million", voxel.Depth / one / 10.0 / portion, 1.0, 1e-6);
  check.Near("opacity", lines::OpacityOf(voxel), 1.0, 1e-12);
}

void CheckRadii(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetSampleDimensions(2, 2, 2);
  voxelizer->SetModelBounds(0.0, 2.0, 0.0, 2.0, 0.0, 2.0);
  voxelizer->SetInputData(lines::MakeLines({ { { 0.2, 0.2, 0.2 }, { 0.8, 0.2, 0.2 } } }));
  {
    lines::Messages messages(voxelizer);
    voxelizer->SetRadius(0.0);
    voxelizer->Update();
    check.That(messages.Has("1 a radius of 0"), "radius 0 is said");
    check.Near("radius 0", lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"), 0.0, 0.0);
  }
  lines::Messages messages(voxelizer);
  voxelizer->SetRadius(50.0);
  voxelizer->Update();
  check.That(messages.Has("1 have a radius above"), "a radius above the voxel's edge is said");
  const double depth = lines::Look(voxelizer->GetOutput(), { 0.0, 0.0, 1.0 }).Depth;
  const double share = 2.0 * 0.6 / 1.5;
  check.Near("taken as the edge", depth, optics::MeanDepthOfShare(share) / (TwoPi / 8.0), 0.03);
}

void CheckSettings(Check& check)
{
  const auto data = lines::MakeLines(lines::RandomLines(200, 3));
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputData(data);
  voxelizer->SetSampleDimensions(5, 4, 3);
  vtkNew<vtkProperty> material;
  material->SetSpecular(1.0);
  voxelizer->SetMaterial(0, material);
  for (int order = 0; order <= 12; ++order)
  {
    for (double power : { 1.0, 30.0, 1000.0 })
    {
      voxelizer->SetMaximumOrder(order);
      voxelizer->SetSpecularPower(0, power);
      voxelizer->Update();
      check.That(IsFinite(voxelizer->GetOutput()), "finite at order " + std::to_string(order));
      for (const glm::dvec3& toViewer : { glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.6, -0.8, 0.0) })
      {
        const auto voxel = lines::Look(voxelizer->GetOutput(), toViewer);
        check.AtLeast("depth", voxel.Depth, 0.0);
        // diffuse pi/4, the highlight at most the same for exponent 1
        check.AtMost("colour", voxel.Color.x, TwoPi / 4.0 + 1e-6);
      }
    }
  }
  for (const glm::ivec3& size : { glm::ivec3(1), glm::ivec3(1024, 64, 64), glm::ivec3(1, 1, 300) })
  {
    voxelizer->SetSampleDimensions(size.x, size.y, size.z);
    voxelizer->SetMaximumOrder(2);
    voxelizer->Update();
    check.That(IsFinite(voxelizer->GetOutput()), "finite on a long grid");
    check.AtLeast("voxels", lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"), 1.0);
  }
  // lines in a plane, on an axis
  voxelizer->SetInputData(lines::MakeLines({ { { 0.0, 0.0, 3.0 }, { 4.0, 0.0, 3.0 } } }));
  voxelizer->SetSampleDimensions(4, 4, 4);
  voxelizer->Update();
  check.Near("a line on an axis", lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"), 4.0, 0.0);
  lines::Messages messages(voxelizer);
  voxelizer->SetMaximumOrder(13);
  check.That(messages.Has("[0, 12]") && voxelizer->GetMaximumOrder() == 12, "order 13 is refused");
}

// A light along the lines, which grazes them, one that makes the half vector lie along them, and one from behind.
void CheckWorldLights(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  lines::SetUnitVoxel(voxelizer);
  voxelizer->SetInputData(lines::MakeLines({ { { 0.5, 0.5, 0.1 }, { 0.5, 0.5, 0.9 } } }));
  vtkNew<vtkProperty> material;
  material->SetSpecular(1.0);
  voxelizer->SetMaterial(0, material);
  const glm::dvec3 toViewer(0.0, 0.6, 0.8);
  for (const glm::dvec3& toLight :
    { glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, -0.6, 0.8), glm::dvec3(0.0, -0.6, -0.8), toViewer })
  {
    vtkNew<vtkLightCollection> lights;
    lights->AddItem(lines::SceneLight(toLight));
    voxelizer->SetLights(lights);
    for (int order : { 0, 3 })
    {
      voxelizer->SetMaximumOrder(order);
      voxelizer->SetSpecularPower(0, order == 0 ? 1.0 : 1000.0);
      voxelizer->Update();
      check.That(IsFinite(voxelizer->GetOutput()), "finite under a light in the world");
      const auto voxel = lines::Look(voxelizer->GetOutput(), toViewer);
      check.AtLeast("depth", voxel.Depth, 1e-3);
      check.AtLeast("colour", voxel.Color.x, 0.0);
      check.AtMost("colour", voxel.Color.x, TwoPi / 4.0 + 1e-6); // as under a headlight
    }
  }
}

void CheckBakedLights(Check& check)
{
  vtkNew<vtkLightCollection> lights;
  const auto light = lines::SceneLight({ 1.0, 2.0, 3.0 });
  lights->AddItem(light);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetSampleDimensions(2, 2, 2);
  voxelizer->SetMaximumOrder(1);
  voxelizer->SetInputData(lines::MakeLines(lines::RandomLines(2, 1)));
  voxelizer->SetLights(lights);
  voxelizer->Update();
  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
  evaluator->SetInputConnection(voxelizer->GetOutputPort());
  lines::Messages messages(evaluator);
  check.That(evaluator->CheckLights(lights), "the baked lights");
  light->SetIntensity(0.5);
  check.That(!evaluator->CheckLights(lights) && !evaluator->CheckLights(lights), "another intensity");
  check.That(!evaluator->CheckLights(nullptr), "a headlight");
  check.That(messages.Has("SetLights()"), "is said once");
  voxelizer->Update();
  check.That(evaluator->CheckLights(lights), "the voxelizer follows its lights");
}

struct Watch
{
  int Events = 0;
  double Last = 0.0;
  bool Rises = true;
  double AbortAt = 2.0;

  void Observe(vtkAlgorithm* algorithm)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long, void* data, void*) {
      auto* watched = vtkAlgorithm::SafeDownCast(caller);
      auto* seen = static_cast<Watch*>(data);
      ++seen->Events;
      seen->Rises = seen->Rises && watched->GetProgress() >= seen->Last;
      seen->Last = watched->GetProgress();
      watched->SetAbortExecute(seen->Last >= seen->AbortAt);
    });
    algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  }
};

void CheckAbortOfEvaluator(Check& check, vtkImageData* voxels)
{
  vtkNew<vtkCamera> camera;
  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
  evaluator->SetInputData(voxels);
  evaluator->SetCamera(camera);
  Watch watch;
  watch.Observe(evaluator);
  for (double abortAt : { 0.01, 0.5, 0.9 })
  {
    watch.Last = 0.0;
    watch.AbortAt = abortAt;
    evaluator->Modified();
    evaluator->Update();
    check.Near("aborted evaluation", evaluator->GetOutput()->GetNumberOfPoints(), 0.0, 0.0);
    evaluator->AbortExecuteOff();
  }
  watch = Watch();
  evaluator->Modified();
  evaluator->Update();
  check.AtLeast("progress events of the evaluator", watch.Events, 20.0);
  check.That(watch.Rises && watch.Last == 1.0, "the evaluator's progress rises to 1");
  check.Near(
    "after an aborted evaluation", evaluator->GetOutput()->GetNumberOfPoints(), 64.0 * 64.0 * 64.0, 0.0);
}

void CheckAbortAndProgress(Check& check)
{
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(300000);
  source->Update();
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(source->GetOutputPort());
  voxelizer->SetSampleDimensions(64, 64, 64);
  Watch watch;
  watch.Observe(voxelizer);
  voxelizer->Update();
  check.AtLeast("progress events", watch.Events, 20.0);
  check.That(watch.Rises && watch.Last == 1.0, "progress rises to 1");
  for (double abortAt : { 0.01, 0.3, 0.7, 0.95 })
  {
    watch = Watch();
    watch.AbortAt = abortAt;
    voxelizer->Modified();
    voxelizer->Update();
    check.Near("aborted output", voxelizer->GetOutput()->GetNumberOfCells(), 0.0, 0.0);
    voxelizer->AbortExecuteOff();
  }
  watch = Watch();
  voxelizer->Modified();
  voxelizer->Update();
  check.AtLeast("after an abort", lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"), 1.0);
  CheckAbortOfEvaluator(check, voxelizer->GetOutput());
}
}

int TestLineVoxelExtremes(int, char*[])
{
  Check check;
  CheckPoints(check);
  CheckEmpty(check);
  CheckManyInOneVoxel(check);
  CheckRadii(check);
  CheckSettings(check);
  CheckWorldLights(check);
  CheckBakedLights(check);
  CheckAbortAndProgress(check);
  return check.ExitCode();
}
