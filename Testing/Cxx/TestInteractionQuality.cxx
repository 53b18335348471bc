// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Presets follow the desired update rate: coarser while the user interacts, as before afterwards, by uniforms alone.

#include "InteractionQuality.h"
#include "TestScene.h"

#include "vtkRenderWindowInteractor.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"
#include "vtkVisibilitySweep.h"

namespace
{
using volumeoptics::CoarsenessFor;

void CheckRule(Check& check)
{
  check.That(CoarsenessFor(0.0, 0.1, 2) == 2, "without a measured frame");
  check.That(CoarsenessFor(0.05, 0.1, 1) == 1, "a frame that fits is coarse");
  check.That(CoarsenessFor(0.15, 0.1, 1) == 2, "one that fits at 2");
  check.That(CoarsenessFor(0.35, 0.1, 1) == 4, "one that fits at 4");
  check.That(CoarsenessFor(100.0, 0.1, 1) == 4, "one that never fits");
  check.That(CoarsenessFor(0.09, 0.1, 2) == 2 && CoarsenessFor(0.09, 0.1, 1) == 1, "no room, to and fro");
  check.That(CoarsenessFor(0.06, 0.1, 2) == 1, "with room it does not become finer");
  check.That(CoarsenessFor(0.19, 0.1, 4) == 4 && CoarsenessFor(0.13, 0.1, 4) == 2, "from 4 to 2");
}

struct State
{
  explicit State(TestScene& scene)
    : Step(scene.Mapper->GetSampleDistance())
    , Grid(scene.Optics->GetOcclusionSweep()->GetGridSize()[0])
    , Links(scene.Optics->GetProgramLinkCount() + scene.Optics->GetOcclusionSweep()->GetProgramLinkCount())
  {
  }
  double Step;
  int Grid;
  int Links;
};

// How many directions of the cone a sample gathered, as the last frame's program had it.
class GatheredDirections
{
public:
  explicit GatheredDirections(TestScene& scene)
  {
    this->Command->SetClientData(&this->Program);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* program, void* drawn) {
      *static_cast<unsigned int*>(program) =
        static_cast<unsigned int>(static_cast<vtkShaderProgram*>(drawn)->GetHandle());
    });
    scene.Mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Command);
  }

  float Get() const
  {
    float numbers[4] = {};
    glGetUniformfv(this->Program, glGetUniformLocation(this->Program, "in_opticsGatherNumbers"), numbers);
    return numbers[0] / numbers[3];
  }

private:
  vtkNew<vtkCallbackCommand> Command;
  unsigned int Program = 0;
};

// With the rates of an interactor, or with those of a window alone.
void CheckFrames(Check& check, const std::string& name, TestScene& scene)
{
  const double stillRate = scene.Window->GetDesiredUpdateRate();
  const GatheredDirections directions(scene);
  scene.Property->OcclusionOn();
  scene.Optics->SetQualityToBalanced();
  const std::vector<unsigned char> still = scene.Render();
  const State fine(scene);
  check.Near(name + ": directions", directions.Get(), scene.Optics->GetVisibilitySamples(), 0.0);
  scene.Window->SetDesiredUpdateRate(1.0e6); // never to be had
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(1.0);
    scene.Render();
  }
  const State coarse(scene);
  check.Near(name + ": step while the camera moves", coarse.Step, 4.0 * fine.Step, 1e-6);
  check.Near(name + ": directions while the camera moves", directions.Get(),
    0.5 * scene.Optics->GetVisibilitySamples(), 0.0);
  check.AtMost(name + ": froxels while the camera moves", coarse.Grid, 0.25 * fine.Grid + 1.0);
  scene.Renderer->GetActiveCamera()->Azimuth(-3.0);
  check.That(scene.Render() != still, name + ": the coarse picture is the fine one");

  scene.Window->SetDesiredUpdateRate(1.01); // a second for 150 x 150 pixels
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Render();
  }
  check.Near(name + ": step at a rate that is easily had", State(scene).Step, fine.Step, 1e-6);

  scene.Window->SetDesiredUpdateRate(1.0e6);
  scene.Render();
  scene.Window->SetDesiredUpdateRate(stillRate);
  scene.Renderer->GetActiveCamera()->SetPosition(1.0, -2.5, 1.2);
  scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  check.AtMost(
    name + ": difference of the picture after the interaction", LargestDifference(scene.Render(), still), 0);
  const State after(scene);
  check.Near(name + ": step after the interaction", after.Step, fine.Step, 0.0);
  check.Near(
    name + ": directions after the interaction", directions.Get(), scene.Optics->GetVisibilitySamples(), 0.0);
  check.That(after.Grid == fine.Grid, name + ": froxels after the interaction");
  check.That(after.Links == fine.Links, name + ": a program is linked for it");
}

// What the user sets is his.
void CheckCustom(Check& check)
{
  TestScene scene;
  scene.Property->OcclusionOn();
  scene.Render();
  const State still(scene);
  scene.Window->SetDesiredUpdateRate(1.0e6);
  scene.Render();
  scene.Render();
  check.That(State(scene).Step == still.Step && State(scene).Grid == still.Grid, "a custom setting changes");
}
}

int TestInteractionQuality(int, char*[])
{
  Check check;
  CheckRule(check);
  TestScene alone;
  CheckFrames(check, "window", alone);
  TestScene scene;
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.Window);
  scene.Window->SetDesiredUpdateRate(interactor->GetStillUpdateRate());
  CheckFrames(check, "interactor", scene);
  CheckCustom(check);
  return check.ExitCode();
}
