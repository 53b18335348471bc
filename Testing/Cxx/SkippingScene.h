// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A TestScene that skips empty space, and comparisons with VTK's own picture and with that without skipping.

#ifndef SkippingScene_h
#define SkippingScene_h

#include "SupportedSettings.h"

#include <set>

namespace
{
// Whether anything is skipped in a row of docs/support.md.
inline bool IsSkippedIn(const Row& row)
{
  const std::set<std::string> without = { "label map", "depth pass", "partitions", "shader property" };
  return without.count(row.Name) == 0;
}

struct SkippingScene : TestScene
{
  explicit SkippingScene(vtkGPUVolumeRayCastMapper* mapper = nullptr)
    : TestScene(mapper)
  {
    this->Window->SetSize(48, 48);
    this->Optics->SkipEmptySpaceOn();
    this->Optics->SetMacrocellSize(4);
  }
};

inline bool Skips(vtkOpticsVolumeMapper* mapper)
{
  return mapper->GetActiveTerms().find("EmptySpace") != std::string::npos;
}

// Two frames: the first one loads the volume.
inline void CompareWithVTK(Check& check, const std::string& name, const Setting& apply, bool isServed = true)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  SkippingScene reference(stock);
  SkippingScene ours;
  apply(reference);
  apply(ours);
  check.That(reference.Render() == ours.Render(), name + ": the first frame is not VTK's");
  check.That(reference.Render() == ours.Render(), name + ": the second frame is not VTK's");
  check.That(Skips(ours.Optics) == isServed, name + (isServed ? ": nothing is skipped" : ": skips"));
}

inline void CompareWithout(Check& check, const std::string& name, const Setting& apply, bool isServed = true)
{
  SkippingScene scene;
  apply(scene);
  const std::vector<unsigned char> with = scene.Render();
  scene.Optics->SkipEmptySpaceOff();
  check.That(with == scene.Render(), name + ": the picture differs from that without skipping");
  scene.Optics->SkipEmptySpaceOn();
  check.That(with == scene.Render(), name + ": the picture differs when skipping again");
  check.That(Skips(scene.Optics) == isServed, name + (isServed ? ": nothing is skipped" : ": skips"));
}

// On a target of float, which tells the last digit.
inline void CompareInFloat(Check& check, const std::string& name, const Setting& apply)
{
  SkippingScene scene;
  apply(scene);
  const std::vector<float> with = scene.RenderFloat();
  scene.Optics->SkipEmptySpaceOff();
  check.That(with == scene.RenderFloat(), name + ": the picture in float differs");
}

inline void UseWard(TestScene& scene)
{
  scene.Property->SetReflectanceModelToWard();
  scene.Property->SetSpecular(0.7);
}
}

#endif
