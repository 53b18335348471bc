// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// With every setting at its default nothing is added: the pixels and the text of the shader, with it
// the textures that it samples, are those of VTK's own mapper.

#include "ShaderText.h"
#include "TestScene.h"

#include <functional>

namespace
{
struct Frame
{
  std::vector<unsigned char> First, Second;
  std::string Text;
};

Frame Draw(TestScene& scene)
{
  const ShaderText shader(scene.Mapper);
  Frame frame;
  frame.First = scene.Render();
  frame.Second = scene.Render();
  frame.Text = shader.Text;
  return frame;
}

using Setting = std::function<void(TestScene&)>;

void Compare(Check& check, const std::string& name, const Setting& setting)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  TestScene reference(stock);
  TestScene ours;
  setting(reference);
  setting(ours);
  const Frame expected = Draw(reference);
  const Frame actual = Draw(ours);
  check.That(expected.First == actual.First, name + ": the first frame differs from VTK's");
  check.That(expected.Second == actual.Second, name + ": the second frame differs from VTK's");
  check.That(
    !expected.Text.empty() && expected.Text == actual.Text, name + ": the shader differs from VTK's");
  check.That(ours.Optics->GetActiveTerms().empty(), name + ": a term is active");
  check.That(ours.Optics->GetTermMemorySize() == 0, name + ": a term holds memory");
}
}

int TestStockIdentity(int, char*[])
{
  Check check;
  Compare(check, "shaded", [](TestScene&) {});
  Compare(check, "not shaded", [](TestScene& scene) { scene.Property->ShadeOff(); });
  Compare(check, "a model, but not shaded", [](TestScene& scene) {
    scene.Property->ShadeOff();
    scene.Property->SetReflectanceModelToWard();
  });
  Compare(check, "settings of a lighting transfer function, but none", [](TestScene& scene) {
    scene.Property->SetLightScale(4.0);
    scene.Property->SetGradientStepLength(2.0);
    scene.Property->HybridNormalsOn();
  });
  Compare(check, "a lighting transfer function, but not shaded", [](TestScene& scene) {
    scene.Property->ShadeOff();
    LightEverywhere(scene, 1.0, 1.0, 1.0);
  });
  Compare(
    check, "maximum intensity", [](TestScene& scene) { scene.Mapper->SetBlendModeToMaximumIntensity(); });
  Compare(check, "parallel projection",
    [](TestScene& scene) { scene.Renderer->GetActiveCamera()->ParallelProjectionOn(); });
  return check.ExitCode();
}
