// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every pair of choices of the mapper's terms that go together (Combinations.h), in one of the rows of a covering
// array: the pixels are finite and in range on a target of float, OpenGL has no error, nothing is said, and the
// shaders' texts are valid GLSL.
//
//   vtkVolumeOpticsCxxTests TestCombinations [--strength N] [--part I N] [--row I] [--list]
//
// draws every N choices instead, one of N parts of the rows, the row of this number alone, or names the rows.

#include "CapturedOutput.h"
#include "CombinationRun.h"
#include "ScenePixels.h"
#include "ShaderText.h"
#include "ShaderValidation.h"

#include "vtkVisibilitySweep.h"

namespace
{
// Texts of the shaders of a row.
struct Texts
{
  std::string Ray;
  std::string Sweep;
};

// Draws a row. Returns what is wrong with it; empty: nothing.
std::string FaultOf(const Combination& row, Texts& texts)
{
  CapturedOutput output;
  CombinationScene scene;
  const ShaderText shader(scene.Mapper);
  Apply(Terms, row, scene);
  const bool hasGradientOpacity = scene.Property->HasGradientOpacity();
  scene.Render();
  const std::string error = FaultOfOpenGL();
  const bool hasWindow =
    scene.Mapper->GetFinalColorWindow() != 1.0F; // VTK's, which takes colours below 0, too
  const std::string pixels = FaultOfPixels(scene.RenderFloat(), hasWindow);
  texts.Ray = shader.Text;
  texts.Sweep = scene.Property->GetOcclusion() ? scene.Optics->GetOcclusionSweep()->GetFragmentShader() : "";
  if (scene.Property->HasGradientOpacity() != hasGradientOpacity)
  {
    return "drawing gives the property a gradient opacity"; // VTK does where it is asked for one
  }
  if (!output.GetTexts().empty())
  {
    return output.GetTexts().front();
  }
  return error.empty() ? pixels : error;
}

// The texts of a row are to be checked, too.
void AddTexts(Check& check, ShaderValidation& validation, const Texts& texts, int number)
{
  const std::string name = "Combination-" + std::to_string(number);
  validation.Add(check, name, texts.Ray);
  if (!texts.Sweep.empty())
  {
    validation.Add(check, name + "-sweep", texts.Sweep);
  }
}
}

int TestCombinations(int argc, char* argv[])
{
  Check check;
  ShaderValidation validation;
  RunCombinations(check, CommandLine(argc, argv), Terms, Exclusions, [&](const Combination& row, int number) {
    Texts texts;
    std::string fault = FaultOf(row, texts);
    if (number >= 0)
    {
      AddTexts(check, validation, texts, number);
    }
    return fault;
  });
  validation.Run(check);
  return check.ExitCode();
}
