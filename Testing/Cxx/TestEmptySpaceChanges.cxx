// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What skips empty space follows what changes: the function, the scalars, the size of cells, the volume; links no
// program but for the shader with it and without it, and takes no memory where it isn't used.

#include "FrameEvents.h"
#include "SmallScene.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkPointData.h"

namespace
{
struct Pair
{
  Pair()
    : Reference(Stock)
  {
    this->Ours.Optics->SkipEmptySpaceOn();
    this->Ours.Optics->SetMacrocellSize(4);
  }

  template <typename Function>
  void Both(Function change)
  {
    change(this->Reference);
    change(this->Ours);
  }

  bool IsSame() { return this->Reference.Render() == this->Ours.Render(); }
  bool Skips() { return this->Ours.Optics->GetActiveTerms() == "EmptySpace"; }

  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> Stock;
  SmallScene Reference;
  SmallScene Ours;
};

void SetBegin(TestScene& scene, double begin)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(begin, 0.0);
  scene.Opacity->AddPoint(begin + 0.1, 0.9);
}

void TestFunction(Check& check)
{
  Pair pair;
  check.That(pair.IsSame() && pair.Skips(), "a scene to begin with");
  const int links = pair.Ours.Optics->GetProgramLinkCount();
  check.That(links == 1, "links " + std::to_string(links) + " programs at first");
  for (const double begin : { 0.7, 0.45, 0.55, 0.9 })
  {
    pair.Both([&](TestScene& scene) { SetBegin(scene, begin); });
    check.That(pair.IsSame(), "opacity from " + std::to_string(begin) + " on");
    check.That(pair.Skips(), "nothing is skipped with opacity from " + std::to_string(begin) + " on");
  }
  check.That(pair.Ours.Optics->GetProgramLinkCount() == links, "a change of the function links a program");

  pair.Both([](TestScene& scene) { SetBegin(scene, -1.0); });
  check.That(pair.IsSame() && !pair.Skips(), "all can be seen");
  check.That(pair.Ours.Optics->GetTermMemorySize() == 0, "a texture that is not used is kept");
  pair.Both([](TestScene& scene) { SetBegin(scene, 0.5); });
  check.That(pair.IsSame() && pair.Skips(), "not all can be seen again");
  check.That(pair.Ours.Optics->GetProgramLinkCount() == links, "a shader used before is linked again");
}

// Gradients are found once for the scalars; a change of the function links no program.
void TestGradientFunction(Check& check)
{
  Pair pair;
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 1.0);
  pair.Both([&](TestScene& scene) { scene.Property->SetGradientOpacity(function); });
  check.That(pair.IsSame() && pair.Skips(), "every gradient is seen");
  const int links = pair.Ours.Optics->GetProgramLinkCount();
  const FrameEvents events(pair.Ours.Optics);
  for (const double begin : { 0.05, 0.1, 0.02 })
  {
    function->RemoveAllPoints();
    function->AddPoint(0.0, 0.0);
    function->AddPoint(begin, 0.0);
    function->AddPoint(begin + 0.01, 1.0);
    check.That(pair.IsSame() && pair.Skips(), "gradients from " + std::to_string(begin) + " on");
  }
  check.That(
    events.Starts == 1 && events.Ends == 1 && events.Rises, "gradients are found once, and it is told");
  check.That(
    pair.Ours.Optics->GetProgramLinkCount() == links, "a change of the gradient opacity links a program");
}

void TestSwitch(Check& check)
{
  Pair pair;
  pair.Ours.Optics->SkipEmptySpaceOff();
  check.That(pair.IsSame() && !pair.Skips(), "off");
  check.That(pair.Ours.Optics->GetProgramLinkCount() == 0, "off, and a program of ours is linked");
  check.That(pair.Ours.Optics->GetTermMemorySize() == 0, "off, and memory is taken");
  pair.Ours.Optics->SkipEmptySpaceOn();
  check.That(pair.IsSame() && pair.Skips(), "on");
  // 32 voxels in cells of 4 are 512 bytes
  check.That(pair.Ours.Optics->GetTermMemorySize() == 1, "memory of 8 x 8 x 8 cells");
  pair.Ours.Optics->SetMacrocellSize(2);
  check.That(pair.IsSame() && pair.Skips(), "smaller cells");
  check.That(pair.Ours.Optics->GetTermMemorySize() == 4, "memory of 16 x 16 x 16 cells");
}

void TestScalars(Check& check)
{
  Pair pair;
  vtkNew<vtkImageData> image;
  pair.Ours.Source->Update();
  image->DeepCopy(pair.Ours.Source->GetOutput());
  pair.Both([&](TestScene& scene) { scene.Mapper->SetInputData(image); });
  check.That(pair.IsSame() && pair.Skips(), "an image");
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (int x = 0; x < 32; ++x)
  {
    scalars->SetComponent((2 * 32 + 3) * 32 + x, 0, 0.9); // a needle where nothing was
  }
  scalars->Modified();
  image->Modified();
  check.That(pair.IsSame() && pair.Skips(), "changed scalars");

  vtkNew<vtkAnalyticVolumeSource> larger;
  larger->SetDimensions(40, 21, 33);
  larger->Update();
  pair.Both([&](TestScene& scene) { scene.Mapper->SetInputData(larger->GetOutput()); });
  check.That(pair.IsSame() && pair.Skips(), "another volume");
}

// A pipeline's new scalars: the ranges are found anew, which the mapper tells of; links no program.
void TestTimeSteps(Check& check)
{
  Pair pair;
  check.That(pair.IsSame() && pair.Skips(), "the first time step");
  const int links = pair.Ours.Optics->GetProgramLinkCount();
  const FrameEvents events(pair.Ours.Optics);
  check.That(pair.IsSame() && events.Starts == 0, "a frame of the same time step finds ranges");
  int step = 0;
  for (const double axis : { 0.5, 0.7 })
  {
    pair.Both([&](TestScene& scene) { scene.Source->SetSemiAxes(axis, 0.3, 0.4); });
    check.That(pair.IsSame(), "a time step");
    ++step;
    check.That(events.Starts == step && events.Ends == step && events.Steps >= 4 * step && events.Rises,
      "progress of a time step");
  }
  check.That(pair.Ours.Optics->GetProgramLinkCount() == links, "a time step links a program");
}

void TestWindows(Check& check)
{
  Pair pair;
  check.That(pair.IsSame(), "the first window");
  pair.Both([](TestScene& scene) {
    scene.Window->RemoveRenderer(scene.Renderer);
    scene.Window = vtkSmartPointer<vtkRenderWindow>::New();
    scene.Window->SetMultiSamples(0);
    scene.Window->SetSize(48, 48);
    scene.Window->AddRenderer(scene.Renderer);
  });
  check.That(pair.IsSame() && pair.Skips(), "another window");
}

std::vector<bool> PickedPixels(TestScene& scene)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 47, 47);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->CaptureBuffers();
  std::vector<bool> picked;
  for (unsigned int pixel = 0; pixel < 48 * 48; ++pixel)
  {
    const unsigned int position[2] = { pixel % 48, pixel / 48 };
    picked.push_back(selector->GetPixelInformation(position).Valid);
  }
  return picked;
}

void TestPickedPixels(Check& check)
{
  Pair pair;
  check.That(pair.IsSame() && pair.Skips(), "a scene to pick in");
  const std::vector<bool> expected = PickedPixels(pair.Reference);
  const auto count = std::count(expected.begin(), expected.end(), true);
  check.That(count > 100 && count < 2000, "VTK picks " + std::to_string(count) + " pixels");
  check.That(PickedPixels(pair.Ours) == expected, "other pixels are picked");
}

std::vector<unsigned char> DepthImage(TestScene& scene)
{
  scene.Mapper->SetRenderToImage(1);
  scene.Window->Render();
  vtkNew<vtkImageData> depth;
  scene.Mapper->GetDepthImage(depth);
  const auto* first = static_cast<const unsigned char*>(depth->GetScalarPointer());
  return { first,
    first + depth->GetNumberOfPoints() * depth->GetNumberOfScalarComponents() * depth->GetScalarSize() };
}

void TestDepthImage(Check& check)
{
  Pair pair;
  const std::vector<unsigned char> expected = DepthImage(pair.Reference);
  check.That(!expected.empty() && *std::max_element(expected.begin(), expected.end()) > 0, "no depths");
  check.That(DepthImage(pair.Ours) == expected && pair.Skips(), "depths of RenderToImage");
}

void TestSettings(Check& check)
{
  vtkNew<vtkOpticsVolumeMapper> mapper;
  check.That(mapper->GetSkipEmptySpace(), "on by default");
  check.That(mapper->GetMacrocellSize() == 0, "cells by default");
  const Warnings warnings(mapper);
  mapper->SetMacrocellSize(1);
  check.That(mapper->GetMacrocellSize() == 2 && warnings.Texts.size() == 1, "cells of one voxel");
  mapper->SetMacrocellSize(65);
  check.That(mapper->GetMacrocellSize() == 64 && warnings.Texts.size() == 2, "cells too large");
  mapper->SetMacrocellSize(0);
  check.That(mapper->GetMacrocellSize() == 0 && warnings.Texts.size() == 2, "automatic cells");
}
}

int TestEmptySpaceChanges(int, char*[])
{
  Check check;
  TestFunction(check);
  TestGradientFunction(check);
  TestSwitch(check);
  TestScalars(check);
  TestTimeSteps(check);
  TestWindows(check);
  TestPickedPixels(check);
  TestDepthImage(check);
  TestSettings(check);
  return check.ExitCode();
}
