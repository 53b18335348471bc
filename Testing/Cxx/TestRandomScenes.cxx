// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes at random: nothing crashes, the pixels are finite and in range on a target of float, OpenGL has no error, and
// what is outside of a range or not supported is said, each thing once.
//
//   vtkVolumeOpticsCxxTests TestRandomScenes [--scenes N] [--seed S] [--vtk]
//
// draws the scenes of N seeds from S on; a faulty one is named by its seed. --vtk: by VTK's own mapper, to see what is
// VTK's fault, and what VTK says.

#include "CapturedOutput.h"
#include "CommandLine.h"
#include "RandomScene.h"
#include "ScenePixels.h"

#include <regex>
#include <set>

namespace
{
// Of what may be said: by the setters, and by what draws.
const char* const Documented[] = { "is outside its range", "is not a number", "is not finite",
  "are not finite", "is none of", "is not set: choose", "does not support", "do not support",
  "Occlusion is left out", "Shadows are left out", "HybridNormals need a scalar opacity function",
  "more lights than", "are not those that the lines' voxels", "normals and anisotropy cannot be used" };

bool IsDocumented(const std::string& text)
{
  return std::any_of(std::begin(Documented), std::end(Documented),
    [&](const char* part) { return text.find(part) != std::string::npos; });
}

// Without who says it, and from where.
std::string MessageOf(const std::string& text)
{
  static const std::regex place("^[\\s\\S]*?0x[0-9a-f]+\\): ");
  return std::regex_replace(text, place, "");
}

// What VTK says of the scene with its own mapper.
std::set<std::string> MessagesOfVTK(std::uint32_t seed)
{
  CapturedOutput output;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  RandomScene scene(seed, stock);
  scene.Render();
  scene.RenderFloat();
  scene.Change();
  scene.RenderFloat();
  FaultOfOpenGL();
  std::set<std::string> messages;
  for (const std::string& text : output.GetTexts())
  {
    messages.insert(MessageOf(text));
  }
  return messages;
}

// Of what VTK doesn't say of the scene, too.
class Messages
{
public:
  explicit Messages(std::uint32_t seed)
    : Seed(seed)
  {
  }

  // last: of the frames in which nothing changes
  std::string FaultOf(const std::vector<std::string>& texts, std::size_t firstOfFrames, std::size_t last)
  {
    std::set<std::string> said;
    for (std::size_t i = 0; i < texts.size(); ++i)
    {
      const bool isOfMapper = texts[i].find("vtkOpticsVolumeMapper (") != std::string::npos;
      const bool isTwice = isOfMapper && i >= firstOfFrames && i < last && !said.insert(texts[i]).second;
      if ((isTwice || !IsDocumented(texts[i])) && !this->IsOfVTK(texts[i]))
      {
        return (isTwice ? "said twice: " : "") + texts[i];
      }
    }
    return std::string();
  }

private:
  bool IsOfVTK(const std::string& text)
  {
    if (!this->HasDrawn)
    {
      this->OfVTK = MessagesOfVTK(this->Seed);
      this->HasDrawn = true;
    }
    return this->OfVTK.count(MessageOf(text)) > 0;
  }

  std::uint32_t Seed;
  bool HasDrawn = false;
  std::set<std::string> OfVTK;
};

// Of a picture of a target of float, and of OpenGL.
std::string FaultOfFrame(RandomScene& scene)
{
  scene.Render();
  const std::string error = FaultOfOpenGL();
  const std::vector<float> picture = scene.RenderFloat();
  FaultOfOpenGL(); // its own
  // without a term the picture is VTK's own, for which nothing is promised
  const std::string terms = scene.Optics->GetActiveTerms();
  const bool isOurs = !terms.empty() && terms != "EmptySpace";
  const bool mayBeNegative = scene.Mapper->GetFinalColorWindow() != 1.0F; // VTK's own
  const std::string fault = !error.empty() ? error : isOurs ? FaultOfPixels(picture, mayBeNegative) : "";
  return fault.empty() ? fault : fault + " (terms: " + terms + ")";
}

// Two frames, and one after changes.
std::string FaultOf(std::uint32_t seed)
{
  CapturedOutput output;
  RandomScene scene(seed);
  const std::size_t firstOfFrames = output.GetTexts().size();
  const std::string fault = FaultOfFrame(scene);
  const std::size_t last = output.GetTexts().size();
  scene.Change();
  const std::string later = FaultOfFrame(scene);
  const std::string said = Messages(seed).FaultOf(output.GetTexts(), firstOfFrames, last);
  const std::string first = !said.empty() ? said : !fault.empty() ? fault : later;
  return first.substr(0, 400);
}
}

int TestRandomScenes(int argc, char* argv[])
{
  Check check;
  const CommandLine line(argc, argv);
  const int first = line.GetNumber("--seed", 0, 1), scenes = line.GetNumber("--scenes", 0, 25);
  for (int seed = first; seed < first + scenes; ++seed)
  {
    if (line.Has("--vtk"))
    {
      for (const std::string& text : MessagesOfVTK(static_cast<std::uint32_t>(seed)))
      {
        std::cout << seed << ": " << text << std::endl;
      }
      continue;
    }
    const std::string fault = FaultOf(static_cast<std::uint32_t>(seed));
    check.That(fault.empty(), "--seed " + std::to_string(seed) + " --scenes 1: " + fault);
  }
  return check.ExitCode();
}
