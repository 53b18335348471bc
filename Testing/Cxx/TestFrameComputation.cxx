// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper computes normals and frames once for a data set, says so by VTK's own events, can be
// aborted and be bounded in memory.

#include "FrameEvents.h"
#include "TestScene.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkRenderWindowInteractor.h"

#include <functional>

namespace
{
void CheckOnce(Check& check)
{
  TestScene scene;
  FrameEvents events(scene.Optics);
  scene.Render();
  check.That(events.Starts == 0, "frames are computed for VTK's own model");
  scene.Property->SetReflectanceModelToWard();
  scene.Render();
  check.That(events.Starts == 1 && events.Ends == 1, "the start or the end is not said once");
  check.That(events.Steps >= 20, "less than 20 steps of progress: " + std::to_string(events.Steps));
  check.That(events.Rises && events.Last == 1.0, "progress does not rise to 1");

  const int steps = events.Steps;
  const std::function<void()> changes[] = {
    [] {},
    [&] { scene.Renderer->GetActiveCamera()->Azimuth(20.0); },
    [&] { scene.Property->SetGlossiness(0.1); },
    [&] { scene.Opacity->AddPoint(0.7, 0.2); },
    [&] { scene.Property->SetReflectanceModelToLafortune(); },
    [&] { scene.Property->SetReflectanceModelToBlinnPhong(); },
    [&] { scene.Property->SetReflectanceModelToWard(); },
    [&] { scene.Window->SetSize(120, 90); },
  };
  for (const auto& change : changes)
  {
    change();
    scene.Render();
  }
  check.That(events.Starts == 1 && events.Ends == 1 && events.Steps == steps,
    "frames are computed again although the data is the same");
  scene.Optics->GetAmbientCovarianceFilter()->SetRadius(4.0);
  scene.Render();
  check.That(events.Starts == 2 && events.Ends == 2, "another radius does not compute the frames once");
}

void CheckAbort(Check& check, double abortAt)
{
  const std::string name = "aborted at " + std::to_string(abortAt);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  TestScene expected(stock);
  TestScene whole;
  whole.Property->SetReflectanceModelToWard();

  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  Warnings warnings(scene.Optics);
  FrameEvents events(scene.Optics);
  events.Window = scene.Window;
  events.AbortAt = abortAt;
  check.That(scene.Render() == expected.Render(), name + ": the picture is not VTK's");
  check.That(scene.Optics->GetActiveTerms().empty(), name + ": the term is active");
  check.That(events.Starts == 1 && events.Ends == 1, name + ": the computation has no one start and end");
  check.That(events.Last < 1.0, name + ": the computation went on");

  events.Window = nullptr;
  check.That(scene.Render() == whole.Render(), name + ": the next picture is not whole");
  check.That(events.Starts == 2 && events.Ends == 2, name + ": the next computation has no start and end");
  scene.Render();
  check.That(events.Starts == 2, name + ": the frames are computed a third time");
  check.That(warnings.Texts.empty(), name + ": the mapper has something to say");
}

// A coarse frame first; where the fine one is aborted, the coarse one stays.
void CheckInteraction(Check& check)
{
  TestScene whole;
  whole.Property->SetReflectanceModelToWard();
  const std::vector<unsigned char> fine = whole.Render();

  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.Window);
  FrameEvents events(scene.Optics);
  scene.Window->SetDesiredUpdateRate(interactor->GetDesiredUpdateRate());
  const std::vector<unsigned char> coarse = scene.Render();
  const unsigned long memory = scene.Optics->GetTermMemorySize();
  check.That(
    coarse != fine && scene.Optics->GetActiveTerms() == "Reflectance", "the first frame is not coarse");

  scene.Window->SetDesiredUpdateRate(interactor->GetStillUpdateRate());
  events.Window = scene.Window;
  events.AbortAt = 0.5;
  check.That(scene.Render() == coarse, "an aborted computation takes the coarse frame away");
  check.That(events.Starts == 2, "the fine frame is not computed");
  events.Window = nullptr;
  check.That(scene.Render() == fine, "the still frame is not fine");
  check.AtLeast("memory of the fine frame", scene.Optics->GetTermMemorySize(), 4 * memory);

  scene.Window->SetDesiredUpdateRate(interactor->GetDesiredUpdateRate());
  check.That(scene.Render() == fine, "a coarse frame replaces the fine one");
  check.That(events.Starts == 3, "an interactive frame computes although there is a fine one");
}

void CheckMemory(Check& check)
{
  TestScene scene;
  Warnings warnings(scene.Optics);
  FrameEvents events(scene.Optics);
  scene.Property->SetReflectanceModelToWard();
  scene.Render();
  const unsigned long whole = scene.Optics->GetTermMemorySize();
  check.That(warnings.Texts.empty(), "the whole frame has something to say");

  const double fraction = scene.Optics->GetMaxMemoryFraction();
  const vtkIdType limit = 40000; // 32^3 voxels of 7 bytes need 229376
  scene.Optics->SetMaxMemoryInBytes(static_cast<vtkIdType>(limit / fraction));
  scene.Render();
  scene.Render();
  check.That(warnings.Texts.size() == 1,
    "a limit of memory is said " + std::to_string(warnings.Texts.size()) + " times, not once");
  check.AtMost("KiB within the limit", scene.Optics->GetTermMemorySize(), limit / 1024.0 + 8.0);
  check.AtMost("KiB within the limit", scene.Optics->GetTermMemorySize(), whole / 2.0);
  check.That(events.Starts == 2, "the limit does not compute the frames once");
  check.That(AreFinite(scene.RenderFloat()), "within the limit a pixel is not finite");

  scene.Optics->SetMaxMemoryInBytes(1);
  scene.Render();
  check.That(scene.Optics->GetActiveTerms() == "Reflectance", "with a byte of memory the term is not active");
  check.That(AreFinite(scene.RenderFloat()), "with a byte of memory a pixel is not finite");

  scene.Optics->SetMaxMemoryInBytes(static_cast<vtkIdType>(1) << 30);
  scene.Render();
  check.That(scene.Optics->GetTermMemorySize() == whole, "a higher limit does not give the whole frame");
}

void CheckPrecision(Check& check)
{
  TestScene scene;
  Warnings warnings(scene.Optics);
  scene.Property->SetReflectanceModelToWard();
  scene.Optics->SetFramePrecision(32);
  const std::vector<unsigned char> exact = scene.Render();
  const double largest = scene.Optics->GetTermMemorySize();
  const struct
  {
    int Bits;
    double LargestDifference; // codes
  } rows[] = { { 8, 30 }, { 16, 2 }, { 32, 0 } };
  for (const auto& row : rows)
  {
    scene.Optics->SetFramePrecision(row.Bits);
    const std::string name = std::to_string(row.Bits) + " bits";
    check.AtMost(
      name + ": largest difference", LargestDifference(exact, scene.Render()), row.LargestDifference);
    check.Near(
      name + ": share of the memory", scene.Optics->GetTermMemorySize() / largest, row.Bits / 32.0, 0.05);
    check.That(AreFinite(scene.RenderFloat()), name + ": a pixel is not finite");
  }
  check.That(warnings.Texts.empty(), "a precision has something to say");
  scene.Optics->SetFramePrecision(12);
  check.That(warnings.Texts.size() == 1 && warnings.Texts[0].find("12") != std::string::npos &&
      scene.Optics->GetFramePrecision() == 32,
    "a precision of 12 bits is not refused with its value");
}
}

int TestFrameComputation(int, char*[])
{
  Check check;
  CheckOnce(check);
  CheckAbort(check, 0.0);
  CheckAbort(check, 0.5);
  CheckInteraction(check);
  CheckMemory(check);
  CheckPrecision(check);
  return check.ExitCode();
}
