// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A user's own replacement in the shader and a uniform of it work beside a term, whatever the model,
// and the list of replacements stays the user's.

#include "TestScene.h"

#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <array>

namespace
{
// The picture in the colour of a uniform.
void ReplaceColor(vtkVolume* volume, float red, float green, float blue)
{
  vtkShaderProperty* shader = volume->GetShaderProperty();
  shader->AddFragmentShaderReplacement("//VTK::Shading::Exit", true,
    "//VTK::Shading::Exit\n  g_fragColor.rgb = userColor * g_fragColor.a;\n", false);
  const float color[3] = { red, green, blue };
  shader->GetFragmentCustomUniforms()->SetUniform3f("userColor", color);
}

// The brightest pixel, channel by channel.
std::array<int, 3> Brightest(const std::vector<unsigned char>& pixels)
{
  std::array<int, 3> largest = {};
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    largest[i % 3] = std::max<int>(largest[i % 3], pixels[i]);
  }
  return largest;
}

void CheckModel(Check& check, TestScene& scene, int model)
{
  scene.Property->SetReflectanceModel(model);
  const std::string name = scene.Property->GetReflectanceModelAsString();
  for (const float red : { 1.0F, 0.0F })
  {
    const float color[3] = { red, 1.0F - red, 0.0F };
    scene.Volume->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniform3f("userColor", color);
    const std::array<int, 3> largest = Brightest(scene.Render());
    check.That(largest[0] > 150 == (red == 1.0F) && largest[1] > 150 == (red == 0.0F) && largest[2] < 100,
      name + ": the picture has not the user's colour");
  }
  check.That(scene.Volume->GetShaderProperty()->GetNumberOfShaderReplacements() == 1,
    name + ": the number of the user's replacements is not 1");
  check.That(scene.Optics->GetActiveTerms().empty() == (model == vtkOpticsVolumeProperty::VTK),
    name + ": the term is not as asked for");
}
}

int TestUserShaders(int, char*[])
{
  Check check;
  TestScene scene;
  ReplaceColor(scene.Volume, 1.0F, 0.0F, 0.0F);
  Warnings warnings(scene.Optics);
  for (const int model :
    { vtkOpticsVolumeProperty::Ward, vtkOpticsVolumeProperty::None, vtkOpticsVolumeProperty::BlinnPhong,
      vtkOpticsVolumeProperty::Lafortune, vtkOpticsVolumeProperty::VTK, vtkOpticsVolumeProperty::Ward })
  {
    CheckModel(check, scene, model);
  }
  check.That(warnings.Texts.empty(), "the mapper has something to say");

  scene.Volume->GetShaderProperty()->ClearAllFragmentShaderReplacements();
  TestScene fresh;
  fresh.Property->SetReflectanceModelToWard();
  check.That(scene.Render() == fresh.Render(), "without the replacement the picture is another one");
  return check.ExitCode();
}
