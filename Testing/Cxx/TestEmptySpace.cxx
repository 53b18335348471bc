// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Skipping empty space changes no byte: for each row of docs/support.md, and for more scenes, the picture with it is
// VTK's own, and with an optical model that without it. Where a scene is not supported, nothing is added.

#include "ShaderText.h"
#include "SupportedSettings.h"

#include "vtkMath.h"

#include <set>

namespace
{
const std::set<std::string> RowsWithout = { "2D transfer function", "label map", "depth pass", "partitions",
  "shader property" };

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

bool Skips(vtkOpticsVolumeMapper* mapper)
{
  return mapper->GetActiveTerms().find("EmptySpace") != std::string::npos;
}

// Two frames: the first one loads the volume.
void CompareWithVTK(Check& check, const std::string& name, const Setting& apply, bool isServed)
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

void CompareWithout(Check& check, const std::string& name, const Setting& apply)
{
  SkippingScene scene;
  apply(scene);
  const std::vector<unsigned char> with = scene.Render();
  scene.Optics->SkipEmptySpaceOff();
  check.That(with == scene.Render(), name + ": the picture differs from that without skipping");
}

void UseWard(TestScene& scene)
{
  scene.Property->SetReflectanceModelToWard();
  scene.Property->SetSpecular(0.7);
}

void TestRows(Check& check)
{
  for (const Row& row : Rows)
  {
    CompareWithVTK(check, row.Name, row.Apply, RowsWithout.count(row.Name) == 0);
    CompareWithout(check, std::string(row.Name) + ", Ward", [&](TestScene& scene) {
      row.Apply(scene);
      UseWard(scene);
    });
  }
}
}

int TestEmptySpace(int, char*[])
{
  Check check;
  TestRows(check);
  return check.ExitCode();
}
