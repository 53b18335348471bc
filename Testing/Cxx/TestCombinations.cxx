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
#include "Combinations.h"
#include "CommandLine.h"
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
  scene.Render();
  const std::string error = FaultOfOpenGL();
  const bool hasWindow = scene.Mapper->GetFinalColorWindow() != 1.0F; // VTK's, which takes colours below 0, too
  const std::string pixels = FaultOfPixels(scene.RenderFloat(), hasWindow);
  texts.Ray = shader.Text;
  texts.Sweep = scene.Property->GetOcclusion() ? scene.Optics->GetOcclusionSweep()->GetFragmentShader() : "";
  if (!output.GetTexts().empty())
  {
    return output.GetTexts().front();
  }
  return error.empty() ? pixels : error;
}

void CheckRow(Check& check, ShaderValidation& validation, const Combination& row, int number)
{
  const std::string name = "Combination-" + std::to_string(number);
  Texts texts;
  const std::string fault = FaultOf(row, texts);
  if (!check.That(fault.empty(), name + " (" + NameOf(Terms, row) + "): " + fault))
  {
    const Combination less = Reduced(Terms, Exclusions, row, [&](const Combination& other) { return !FaultOf(other, texts).empty(); });
    std::cout << "with fewer choices, " << NameOf(Terms, less) << ": " << FaultOf(less, texts) << std::endl;
  }
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
  const CommandLine line(argc, argv);
  const CoveringArray array = Cover(Terms, Exclusions, line.GetNumber("--strength", 0, 2));
  const std::vector<Combination>& rows = array.GetRows();
  const int part = line.GetNumber("--part", 0, 1), parts = line.GetNumber("--part", 1, 1);
  const int only = line.GetNumber("--row", 0, -1);
  std::cout << rows.size() << " rows; " << array.GetNumberOfImpossible() << " combinations in none of them\n";
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
  {
    if (line.Has("--list"))
    {
      std::cout << i << ": " << NameOf(Terms, rows[i]) << '\n';
    }
    else if (only < 0 ? i % parts == part - 1 : i == only)
    {
      CheckRow(check, validation, rows[i], i);
    }
  }
  validation.Run(check);
  return check.ExitCode();
}
