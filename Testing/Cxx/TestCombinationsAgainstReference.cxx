// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every pair of choices (Combinations.h) that the reference in double models, in one of the rows of a covering array:
// the picture on a target of float against it, over the same normals and frames.
//
//   vtkVolumeOpticsCxxTests TestCombinationsAgainstReference [--strength N] [--part I N] [--row I] [--list]
//
// as TestCombinations.

#include "CombinationRun.h"
#include "ReferencePictures.h"

using namespace reference;

namespace
{
// Rays that graze a surface, or meet light that does, fall on either side of it by rounding.
const std::size_t GrazingPixels = 4;

// In 255ths, of the others: as in the tests of each term; VTK's own light as in TestReferenceAgainstVTK.
const double LargestRootMeanSquare = 0.1;
const double LargestOfVTK = 1.0;

// What the reference does not model is marked in Combinations.h; and of these the one or the other.
const std::vector<Exclusion> Unmodelled = {
  // VTK's own model: one headlight on both sides of a surface
  { "reflectance", { "VTK" }, "lights", {} },
  { "reflectance", { "VTK" }, "sides", {} },
  // where an isosurface lies within a segment is found by four points of it, which is not enough in a long one
  { "steps", {}, "isosurfaces", {} },
};

std::vector<Term> ModelledTerms()
{
  std::vector<Term> terms = Terms;
  for (Term& term : terms)
  {
    term.Choices.erase(std::remove_if(term.Choices.begin(), term.Choices.end(),
                         [](const Choice& choice) { return !choice.IsModelled; }),
      term.Choices.end());
  }
  return terms;
}

std::vector<Exclusion> AllExclusions()
{
  std::vector<Exclusion> all = Exclusions;
  all.insert(all.end(), Unmodelled.begin(), Unmodelled.end());
  return all;
}

// In 255ths, of all pixels but those that differ most.
double RootMeanSquare(TestScene& stage, const Image& truth, vtkImageData* picture)
{
  const double* rgb = stage.Renderer->GetBackground();
  const Image shown = Over(truth, Vector(rgb[0], rgb[1], rgb[2]));
  const auto* pixels = static_cast<const float*>(picture->GetScalarPointer());
  std::vector<double> squares;
  for (std::size_t i = 0; i < shown.pixels.size(); ++i)
  {
    const Vector difference =
      Vector(shown.pixels[i]) - Vector(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]);
    squares.push_back(glm::dot(difference, difference) / 3.0);
  }
  std::sort(squares.begin(), squares.end());
  squares.resize(squares.size() - GrazingPixels);
  double sum = 0.0;
  for (const double square : squares)
  {
    sum += square;
  }
  return 255.0 * std::sqrt(sum / static_cast<double>(squares.size()));
}

std::string FaultOf(const std::vector<Term>& terms, const Combination& row)
{
  CombinationScene stage;
  Apply(terms, row, stage);
  // 256 points blunt the function's edges, of which an isosurface may show one alone (TestLightingAgainstReference)
  stage.Optics->SetLightingTableSize(1024);
  const int bits = stage.Optics->GetFramePrecision();
  Frames frames(stage);
  stage.Optics->SetFramePrecision(bits);
  const auto picture = FloatPicture(stage);
  const bool isLitByVTK =
    stage.Property->GetShade() && stage.Optics->GetActiveTerms().find("Reflectance") == std::string::npos;
  const double off = RootMeanSquare(stage, Render(SceneOf(stage, frames)), picture);
  return off <= (isLitByVTK ? LargestOfVTK : LargestRootMeanSquare) ? ""
                                                                    : "rms " + std::to_string(off) + "/255";
}
}

int TestCombinationsAgainstReference(int argc, char* argv[])
{
  Check check;
  const std::vector<Term> terms = ModelledTerms();
  RunCombinations(check, CommandLine(argc, argv), terms, AllExclusions(),
    [&](const Combination& row, int) { return FaultOf(terms, row); });
  return check.ExitCode();
}
