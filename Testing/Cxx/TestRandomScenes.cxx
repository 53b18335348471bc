// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes at random: nothing crashes, the pixels are finite and in range on a target of float, OpenGL has no error, and
// what is outside of a range or not supported is said, each thing once.
//
//   vtkVolumeOpticsCxxTests TestRandomScenes [--scenes N] [--seed S] [--skipping | --vtk]
//
// draws the scenes of N seeds from S on; a faulty one is named by its seed. One that ends in a crash is, too, unless it
// does so by VTK's own mapper. --skipping: whether the pictures are
// those without skipping empty space, to the last bit of a float. --vtk: by that mapper, to see what is VTK's fault, and what VTK says.

#include "CapturedOutput.h"
#include "ChildProcess.h"
#include "CommandLine.h"
#include "RandomScene.h"
#include "ScenePixels.h"

#include <regex>
#include <set>

namespace
{
// Of what may be said: by the setters, and by what draws.
const char* const Documented[] = { "is outside its range", "is not a number", "is not finite",
  "are not finite", "is none of", "is not set: choose", "is not set: reflectance model", "is not added",
  "no boundary is added", "there is no boundary", "there is no rule", "does not support", "do not support",
  "Occlusion is left out", "Shadows are left out", "The block of lines is left out",
  "HybridNormals need a scalar opacity function", "more lights than", "are not those that the lines' voxels",
  "normals and anisotropy cannot be used" };

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

// The scene of a seed by VTK's own mapper, drawn when something is asked of it.
class SceneOfVTK
{
public:
  explicit SceneOfVTK(std::uint32_t seed)
    : Seed(seed)
  {
  }

  const std::set<std::string>& GetMessages()
  {
    this->Draw();
    return this->Messages;
  }

  // Of a shader that VTK cannot compile, the whole text is said.
  bool Says(const std::string& text)
  {
    this->Draw();
    const bool isOfShader = text.find("vtkShaderProgram (") != std::string::npos;
    return isOfShader ? std::any_of(this->Messages.begin(), this->Messages.end(),
                          [](const std::string& own) { return own.find("Shader failed to compile") == 0; })
                      : this->Messages.count(MessageOf(text)) > 0;
  }

  // What is wrong with the pixels of the frame before the changes, or of that after them.
  const std::string& GetFault(int frame)
  {
    this->Draw();
    return this->Faults[frame];
  }

private:
  void Draw()
  {
    if (this->IsDrawn)
    {
      return;
    }
    CapturedOutput output;
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
    RandomScene scene(this->Seed, stock);
    scene.Render();
    this->Faults[0] = FaultOfPixels(scene.RenderFloat());
    scene.Change();
    scene.Render();
    this->Faults[1] = FaultOfPixels(scene.RenderFloat());
    FaultOfOpenGL();
    for (const std::string& text : output.GetTexts())
    {
      this->Messages.insert(MessageOf(text));
    }
    this->IsDrawn = true;
  }

  std::uint32_t Seed;
  bool IsDrawn = false;
  std::set<std::string> Messages;
  std::string Faults[2];
};

// Of what VTK doesn't say of the scene, too. last: of the frames in which nothing changes.
std::string FaultOfMessages(
  const std::vector<std::string>& texts, std::size_t firstOfFrames, std::size_t last, SceneOfVTK& ofVTK)
{
  std::set<std::string> said;
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    const bool isOfMapper = texts[i].find("vtkOpticsVolumeMapper (") != std::string::npos;
    const bool isTwice = isOfMapper && i >= firstOfFrames && i < last && !said.insert(texts[i]).second;
    if ((isTwice || !IsDocumented(texts[i])) && !ofVTK.Says(texts[i]))
    {
      return (isTwice ? "said twice: " : "") + texts[i];
    }
  }
  return std::string();
}

// Without a term that shades the picture is VTK's own, for which nothing is promised.
bool IsPictureOfVTK(const std::string& terms)
{
  return terms.empty() || terms == "EmptySpace" || terms == "Piece" || terms == "EmptySpace,Piece";
}

// Opacity may be above 1 where a function of VTK's is.
std::string FaultOfPicture(RandomScene& scene, int frame, SceneOfVTK& ofVTK)
{
  const std::string terms = scene.Optics->GetActiveTerms();
  const std::vector<float> picture = scene.RenderFloat();
  const bool mayBeNegative = scene.Mapper->GetFinalColorWindow() != 1.0F; // VTK's own
  const std::string fault = IsPictureOfVTK(terms) ? "" : FaultOfPixels(picture, mayBeNegative);
  const bool isOfVTK = !fault.empty() && AreFinite(picture) && !ofVTK.GetFault(frame).empty();
  return fault.empty() || isOfVTK ? "" : fault + " (terms: " + terms + ")";
}

// Of a picture of a target of float, and of OpenGL.
std::string FaultOfFrame(RandomScene& scene, int frame, SceneOfVTK& ofVTK)
{
  scene.Render();
  const std::string error = FaultOfOpenGL();
  const std::string fault = FaultOfPicture(scene, frame, ofVTK);
  FaultOfOpenGL(); // that of reading a picture back
  return error.empty() ? fault : error;
}

// Two frames, and sometimes one after changes.
std::string FaultOf(std::uint32_t seed)
{
  CapturedOutput output;
  RandomScene scene(seed);
  SceneOfVTK ofVTK(seed);
  const std::size_t firstOfFrames = output.GetTexts().size();
  const std::string fault = FaultOfFrame(scene, 0, ofVTK);
  const std::size_t last = output.GetTexts().size();
  const bool changes = seed % 2 == 0; // half of them, as each frame links programs of its own
  if (changes)
  {
    scene.Change();
  }
  const std::string later = changes ? FaultOfFrame(scene, 1, ofVTK) : "";
  const std::string said = FaultOfMessages(output.GetTexts(), firstOfFrames, last, ofVTK);
  const std::string first = !said.empty() ? said : !fault.empty() ? fault : later;
  return first.substr(0, 400);
}

bool AreSame(float a, float b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

// What skips empty space, and what does not, must not depend on how long a frame takes.
std::string FaultOfSkipping(std::uint32_t seed)
{
  CapturedOutput output;
  RandomScene scene(seed);
  scene.Mapper->SetAutoAdjustSampleDistances(0);
  scene.Optics->SetQualityToCustom();
  scene.Optics->SkipEmptySpaceOn();
  const std::vector<float> skipping = scene.RenderFloat();
  const std::string terms = scene.Optics->GetActiveTerms();
  scene.Optics->SkipEmptySpaceOff();
  const std::vector<float> all =
    terms.empty() ? skipping : scene.RenderFloat(); // VTK's own picture may change
  const auto differ = std::mismatch(all.begin(), all.end(), skipping.begin(), AreSame);
  return differ.first == all.end()
    ? ""
    : "pixel " + std::to_string((differ.first - all.begin()) / 4) + ": " + std::to_string(*differ.second) +
      " with skipping, " + std::to_string(*differ.first) + " without (terms: " + terms + ")";
}

void PrintSceneOfVTK(std::uint32_t seed)
{
  SceneOfVTK scene(seed);
  for (const std::string& text : scene.GetMessages())
  {
    std::cout << seed << ": " << text << std::endl;
  }
  std::cout << seed << ": pixels: " << scene.GetFault(0) << "; after changes: " << scene.GetFault(1)
            << std::endl;
}

// What is known of the scenes when one of them ends the process.
struct Progress
{
  int Seed;
  bool HasFault = false;
};

using FaultOfSeed = std::string (*)(std::uint32_t seed);

void DrawScenes(int last, FaultOfSeed findFault, const Shared<Progress>& progress)
{
  for (; progress->Seed <= last; ++progress->Seed)
  {
    const std::string fault = findFault(static_cast<std::uint32_t>(progress->Seed));
    Check check;
    progress->HasFault |=
      !check.That(fault.empty(), "--seed " + std::to_string(progress->Seed) + " --scenes 1: " + fault);
  }
}

// Whether all is well with the scenes; those behind one that ends in a crash are drawn as well.
bool AreWell(int first, int last, FaultOfSeed findFault)
{
  Shared<Progress> progress;
  for (progress->Seed = first; progress->Seed <= last; ++progress->Seed)
  {
    if (EndsWell([&] { DrawScenes(last, findFault, progress); }))
    {
      continue;
    }
    const bool isOfVTK = !EndsWell([&] { SceneOfVTK(progress->Seed).GetMessages(); });
    std::cout << (isOfVTK ? "VTK's own mapper" : "FAILED") << " --seed " << progress->Seed
              << " --scenes 1: ends in a crash" << std::endl;
    progress->HasFault |= !isOfVTK;
  }
  return !progress->HasFault;
}
}

int TestRandomScenes(int argc, char* argv[])
{
  const CommandLine line(argc, argv);
  const int first = line.GetNumber("--seed", 0, 1), scenes = line.GetNumber("--scenes", 0, 25);
  const int last = first + scenes - 1;
  if (line.Has("--vtk"))
  {
    for (int seed = first; seed <= last; ++seed)
    {
      PrintSceneOfVTK(static_cast<std::uint32_t>(seed));
    }
    return EXIT_SUCCESS;
  }
  return AreWell(first, last, line.Has("--skipping") ? FaultOfSkipping : FaultOf) ? EXIT_SUCCESS
                                                                                  : EXIT_FAILURE;
}
