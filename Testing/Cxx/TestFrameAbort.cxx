// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A frame that is given up while it is drawn: how much is drawn after that, what is left, and the next frame.

#include "TestScene.h"

#include "vtkVisibilitySweep.h"

#include <ctime>
#include <functional>

namespace
{
constexpr int Stride = 4; // tries: each second of the sixteen tiles, which have two questions each

// Answers AbortCheckEvent: yes at the question of this number, and from then on nobody is asked.
struct Aborter
{
  explicit Aborter(vtkRenderWindow* window)
    : Window(window)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
      auto* self = static_cast<Aborter*>(client);
      if (self->Questions++ == self->At)
      {
        self->Window->SetAbortRender(1);
        self->Time = std::clock();
      }
    });
    window->AddObserver(vtkCommand::AbortCheckEvent, this->Command);
  }
  ~Aborter() { this->Window->RemoveObserver(this->Command); }

  vtkNew<vtkCallbackCommand> Command;
  vtkRenderWindow* Window;
  int At = -1; // never
  int Questions = 0;
  std::clock_t Time = 0; // of the processors
};

std::size_t CountDifferent(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3)
  {
    count += !std::equal(a.begin() + i, a.begin() + i + 3, b.begin() + i) ? 1 : 0;
  }
  return count;
}

std::vector<unsigned char> Background(TestScene& scene)
{
  scene.Volume->VisibilityOff();
  std::vector<unsigned char> background = scene.Render();
  scene.Volume->VisibilityOn();
  return background;
}

// Gives the frame up at each question in turn. Of what a whole frame draws, each part has at most a quarter.
void CheckEachQuestion(Check& check, const std::string& name, TestScene& scene)
{
  const std::vector<unsigned char> background = Background(scene);
  const std::vector<unsigned char> unwatched = scene.Render();
  const int links = scene.Optics->GetProgramLinkCount();
  int questions = 0;
  {
    Aborter aborter(scene.Window);
    check.That(scene.Render() == unwatched, name + ": a watched frame is another picture");
    questions = aborter.Questions;
  }
  check.AtLeast(name + ": questions of a frame", questions, 4);
  const std::size_t whole = CountDifferent(background, unwatched);
  std::size_t before = 0;
  for (int at = 0; at <= questions; at += at + Stride < questions ? Stride : 1)
  {
    scene.Renderer->GetActiveCamera()->Modified();
    Aborter aborter(scene.Window);
    aborter.At = at;
    const std::vector<unsigned char> left = scene.Render();
    const std::size_t drawn = CountDifferent(background, left);
    check.That(drawn >= before, name + ": a later abort leaves less of the frame");
    check.AtMost(name + ": share of the pixels between two tries", 1.0 * (drawn - before) / whole, 0.25);
    check.That(drawn + CountDifferent(unwatched, left) == whole, name + ": a pixel is of no whole picture");
    check.That(aborter.Questions == std::min(at + 1, questions), name + ": is asked after the abort");
    before = drawn;
    check.That(at == questions || scene.Window->GetAbortRender(), name + ": the window forgets the abort");
  }
  check.That(before == whole, name + ": the last frame is not whole");
  check.That(scene.Render() == unwatched, name + ": the frame after the aborts is another picture");
  check.That(scene.Optics->GetProgramLinkCount() == links, name + ": an abort links programs");
}

// Processor time after the abort, of llvmpipe's threads too, over that of a whole frame.
void CheckLatency(Check& check, const std::string& name, TestScene& scene, int at)
{
  scene.Render();
  double least = 1.0; // of two: another process may take the caches away
  for (int repetition = 0; repetition < 2; ++repetition)
  {
    Aborter aborter(scene.Window);
    scene.Optics->Modified(); // sweeps are found anew
    scene.Optics->GetOcclusionSweep()->Modified();
    const std::clock_t begin = std::clock();
    scene.Window->Render();
    const double frame = static_cast<double>(std::clock() - begin);
    scene.Optics->GetOcclusionSweep()->Modified();
    aborter.Questions = 0;
    aborter.At = at;
    scene.Window->Render();
    least = std::min(least, static_cast<double>(std::clock() - aborter.Time) / frame);
  }
  check.AtMost(name + ": time after the abort over a frame's", least, 0.25);
}

void WithOcclusion(TestScene& scene)
{
  scene.Property->OcclusionOn();
  scene.Property->ShadowsOn();
  scene.Optics->SetVisibilityGridSize(48);
  scene.Optics->SetVisibilitySamples(4);
}

// While the sweep is drawn, nothing of the volume is, and the sweep does not count as one.
void CheckSweep(Check& check)
{
  TestScene scene;
  WithOcclusion(scene);
  const std::vector<unsigned char> background = Background(scene);
  const std::vector<unsigned char> whole = scene.Render();
  const int sweeps = scene.Optics->GetOcclusionSweep()->GetSweepCount();
  {
    Aborter aborter(scene.Window);
    aborter.At = 5; // of the sixteen parts of the first sweep
    scene.Optics->GetOcclusionSweep()->Modified();
    check.That(scene.Render() == background, "sweep: the volume is drawn with half a sweep");
  }
  check.That(scene.Optics->GetOcclusionSweep()->GetSweepCount() == sweeps, "sweep: half a sweep counts");
  check.That(scene.Render() == whole, "sweep: the next frame is another picture");
  check.That(scene.Optics->GetOcclusionSweep()->GetSweepCount() == sweeps + 1, "sweep: it is not repeated");
}

void CheckShadows(Check& check)
{
  TestScene scene;
  scene.Window->SetSize(72, 72);
  scene.Property->ShadowsOn();
  scene.Optics->SetVisibilityGridSize(48);
  const std::vector<unsigned char> whole = scene.Render();
  for (const int at : { 0, 3, 9 })
  {
    scene.Property->SetShadowAngle(scene.Property->GetShadowAngle() > 0.0 ? 0.0 : 5.0);
    const std::vector<unsigned char> other = [&] {
      TestScene fresh;
      fresh.Window->SetSize(72, 72);
      fresh.Property->ShadowsOn();
      fresh.Optics->SetVisibilityGridSize(48);
      fresh.Property->SetShadowAngle(scene.Property->GetShadowAngle());
      return fresh.Render();
    }();
    {
      Aborter aborter(scene.Window);
      aborter.At = at;
      scene.Render();
    }
    check.That(scene.Render() == other, "shadows: the frame after an abort is another picture");
  }
}
}

int TestFrameAbort(int, char*[])
{
  Check check;
  const std::pair<const char*, std::function<void(TestScene&)>> scenes[] = {
    { "stock", [](TestScene&) {} },
    { "Ward", [](TestScene& scene) { scene.Property->SetReflectanceModelToWard(); } },
    { "adjusted distances", [](TestScene& scene) { scene.Mapper->SetAutoAdjustSampleDistances(1); } },
    { "skipping", [](TestScene& scene) { scene.Optics->SkipEmptySpaceOn(); } },
    { "half a viewport", [](TestScene& scene) { scene.Renderer->SetViewport(0.5, 0.2, 1.0, 0.9); } },
    { "camera inside",
      [](TestScene& scene) { scene.Renderer->GetActiveCamera()->SetPosition(0.0, -0.7, 0.1); } },
  };
  for (const auto& [name, change] : scenes)
  {
    TestScene scene;
    scene.Window->SetSize(72, 72);
    change(scene);
    CheckEachQuestion(check, name, scene);
  }
  CheckSweep(check);
  CheckShadows(check);
  TestScene slow;
  slow.Property->SetReflectanceModelToWard();
  slow.Mapper->SetSampleDistance(0.005F);
  CheckLatency(check, "rays", slow, 7);
  TestScene swept;
  WithOcclusion(swept);
  CheckLatency(check, "sweep", swept, 7);
  return check.ExitCode();
}
