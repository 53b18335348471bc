// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes at random: nothing crashes, the pixels are finite and in range on a target of float, OpenGL has no error, and
// what is outside of a range or not supported is said, each thing once.
//
//   vtkVolumeOpticsCxxTests TestRandomScenes [--scenes N] [--seed S]
//
// draws the scenes of N seeds from S on; a faulty one is named by its seed.

#include "CapturedOutput.h"
#include "CommandLine.h"
#include "RandomScene.h"
#include "ScenePixels.h"

#include <set>

namespace
{
// Of what may be said: by the setters, and by what draws.
const char* const Documented[] = { "is outside its range", "is not a number", "is not finite", "is none of",
  "is not set: choose", "does not support", "do not support", "Occlusion is left out",
  "Shadows are left out" };

bool IsDocumented(const std::string& text)
{
  return std::any_of(std::begin(Documented), std::end(Documented),
    [&](const char* part) { return text.find(part) != std::string::npos; });
}

std::string FaultOfMessages(const std::vector<std::string>& texts, std::size_t firstOfFrames)
{
  std::set<std::string> said;
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    if (!IsDocumented(texts[i]))
    {
      return texts[i];
    }
    const bool isOurs = texts[i].find("vtkOpticsVolumeMapper (") != std::string::npos; // VTK repeats its own
    if (isOurs && i >= firstOfFrames && !said.insert(texts[i]).second)
    {
      return "said twice: " + texts[i];
    }
  }
  return std::string();
}

std::string FaultOf(std::uint32_t seed)
{
  CapturedOutput output;
  RandomScene scene(seed);
  const std::size_t firstOfFrames = output.GetTexts().size();
  scene.Render();
  const std::string error = FaultOfOpenGL();
  const std::vector<float> picture = scene.RenderFloat();
  // without a term the picture is VTK's own, for which nothing is promised
  const std::string terms = scene.Optics->GetActiveTerms();
  const std::string pixels = terms.empty() || terms == "EmptySpace" ? "" : FaultOfPixels(picture);
  const std::string said = FaultOfMessages(output.GetTexts(), firstOfFrames);
  const std::string fault = !said.empty() ? said : !error.empty() ? error : pixels;
  return fault.empty() ? fault : fault.substr(0, 400) + " (terms: " + terms + ")";
}
}

int TestRandomScenes(int argc, char* argv[])
{
  Check check;
  const CommandLine line(argc, argv);
  const int first = line.GetNumber("--seed", 0, 1), scenes = line.GetNumber("--scenes", 0, 25);
  for (int seed = first; seed < first + scenes; ++seed)
  {
    const std::string fault = FaultOf(static_cast<std::uint32_t>(seed));
    check.That(fault.empty(), "--seed " + std::to_string(seed) + " --scenes 1: " + fault);
  }
  return check.ExitCode();
}
