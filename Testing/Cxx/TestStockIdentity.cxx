// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// With every setting at its default nothing is added: the pixels and the text of the shader, with it
// the textures that it samples, are those of VTK's own mapper.

#include "TestScene.h"

#include "vtkShader.h"
#include "vtkShaderProgram.h"

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
  Frame frame;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&frame);
  command->SetCallback([](vtkObject*, unsigned long, void* client, void* program) {
    auto* seen = static_cast<Frame*>(client);
    vtkShader* shader = static_cast<vtkShaderProgram*>(program)->GetFragmentShader();
    seen->Text = shader->GetSource();
  });
  scene.Mapper->AddObserver(vtkCommand::UpdateShaderEvent, command);
  frame.First = scene.Render();
  frame.Second = scene.Render();
  return frame;
}

using Setting = std::function<void(TestScene&)>;

void Compare(Verdict& verdict, const std::string& name, const Setting& setting)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  TestScene reference(stock);
  TestScene ours;
  setting(reference);
  setting(ours);
  const Frame expected = Draw(reference);
  const Frame actual = Draw(ours);
  verdict.Check(expected.First == actual.First, name + ": the first frame differs from VTK's");
  verdict.Check(expected.Second == actual.Second, name + ": the second frame differs from VTK's");
  verdict.Check(!expected.Text.empty() && expected.Text == actual.Text, name + ": the shader differs from VTK's");
  verdict.Check(ours.Optics->GetActiveTerms().empty(), name + ": a term is active");
  verdict.Check(ours.Optics->GetTermMemorySize() == 0, name + ": a term holds memory");
}
}

int TestStockIdentity(int, char*[])
{
  Verdict verdict;
  Compare(verdict, "shaded", [](TestScene&) {});
  Compare(verdict, "not shaded", [](TestScene& scene) { scene.Property->ShadeOff(); });
  Compare(verdict, "a model, but not shaded", [](TestScene& scene) {
    scene.Property->ShadeOff();
    scene.Property->SetReflectanceModelToWard();
  });
  Compare(verdict, "maximum intensity",
    [](TestScene& scene) { scene.Mapper->SetBlendModeToMaximumIntensity(); });
  Compare(verdict, "parallel projection",
    [](TestScene& scene) { scene.Renderer->GetActiveCamera()->ParallelProjectionOn(); });
  return verdict.Result();
}
