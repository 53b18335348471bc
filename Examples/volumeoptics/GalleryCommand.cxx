// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics gallery: all figures of the method on one page.

#include "Commands.h"
#include "GalleryField.h"
#include "GalleryList.h"
#include "ScoreScenes.h"
#include "GalleryPage.h"
#include "GalleryScores.h"
#include "GalleryStudio.h"
#include "Progress.h"
#include "TracedPicture.h"
#include "UserError.h"
#include "VolumeScene.h"

#include <algorithm>
#include <filesystem>
#include <memory>

namespace
{
const char* const DefaultCranium = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";

struct GalleryOptions
{
  std::string Folder = "gallery";
  std::string Cranium = DefaultCranium;
  bool WithoutCranium = false;
  bool WithoutScores = false;
  std::string Only; // part of the title; empty: all
  std::vector<std::string> ScoreRules = { "equal-size", "saturated" };
  std::string TraceFolder; // empty: nothing is traced
  bool Headless = false;
  bool Force = false;
};

constexpr int TracedRays = 24; // from each of some dozens of samples of a pixel

std::vector<GallerySection> ChosenSections(const GalleryOptions& options)
{
  std::vector<GallerySection> sections = GalleryList(!options.WithoutCranium);
  const auto isLeftOut = [&](const GallerySection& section) {
    return section.Title.find(options.Only) == std::string::npos;
  };
  sections.erase(std::remove_if(sections.begin(), sections.end(), isLeftOut), sections.end());
  if (sections.empty())
  {
    throw UserError(
      "No section's title contains '" + options.Only + "'. Leave --only out to see the titles.");
  }
  return sections;
}

std::size_t CountPictures(const std::vector<GallerySection>& sections)
{
  std::size_t count = 0;
  for (const GallerySection& section : sections)
  {
    count += section.Pictures.size();
  }
  return count;
}

PictureResult ResultOf(const GalleryPicture& picture, bool hasScore, GalleryStudio& studio)
{
  if (picture.TracedAngle > 0.0)
  {
    return studio.Keep(picture.Name);
  }
  if (!picture.Lines.Source.empty())
  {
    return studio.DrawLines(picture.Name, picture.Lines, picture.Settings);
  }
  return hasScore ? studio.Draw(picture.Name, picture.Field, picture.Settings)
                  : studio.DrawUnscored(picture.Name, picture.Field, picture.Settings);
}

void DrawSections(GalleryContents& contents, GalleryStudio& studio)
{
  Progress drawing("Pictures");
  const double count = static_cast<double>(CountPictures(contents.Sections));
  for (const GallerySection& section : contents.Sections)
  {
    for (const GalleryPicture& picture : section.Pictures)
    {
      drawing.Update(contents.Results.size() / count, section.Title + ": " + picture.Title);
      contents.Results[picture.Name] = ResultOf(picture, section.HasScores, studio);
    }
    drawing.Line(section.Title);
  }
}

std::vector<ScoreRow> DrawScores(
  const std::string& rule, const std::vector<ScoreScene>& scenes, GalleryStudio& studio)
{
  Progress scoring("Scores, " + rule);
  std::size_t views = 0, done = 0;
  for (const ScoreScene& scene : scenes)
  {
    views += scene.Views.size();
  }
  std::string last;
  return MeasureScores(rule, scenes, studio, [&](const std::string& scene) {
    scoring.Update(static_cast<double>(++done) / views, scene);
    if (scene != last)
    {
      scoring.Line(scene);
      last = scene;
    }
  });
}

// The pictures that the gallery keeps, anew.
void TracePictures(const GalleryOptions& options)
{
  std::filesystem::create_directories(options.TraceFolder);
  for (const GallerySection& section : ChosenSections(options))
  {
    for (const GalleryPicture& picture : section.Pictures)
    {
      if (picture.TracedAngle > 0.0)
      {
        const Progress tracing("Tracing " + picture.Name);
        VolumeScene scene(GalleryField(picture.Field, options.Cranium), OffScreenWindow(options.Headless));
        scene.Apply(picture.Settings);
        TracePicture(
          scene, picture.TracedAngle, TracedRays, options.TraceFolder + "/" + picture.Name + ".png");
      }
    }
  }
}

void MakeGallery(const GalleryOptions& options)
{
  if (!options.WithoutCranium && !std::filesystem::exists(options.Cranium))
  {
    throw UserError("The CT '" + options.Cranium +
      "' is not there. Install the package "
      "invesalius-examples, or give --cranium FILE or --without-cranium.");
  }
  if (!options.TraceFolder.empty())
  {
    TracePictures(options);
    return;
  }
  GalleryStudio studio(options.Folder, options.Cranium, options.Headless, options.Force);
  GalleryContents contents;
  contents.Sections = ChosenSections(options);
  DrawSections(contents, studio);
  if (!options.WithoutScores)
  {
    for (const std::string& rule : options.ScoreRules)
    {
      const auto rows = DrawScores(rule, ScoreScenes(!options.WithoutCranium, rule), studio);
      contents.Scores.insert(contents.Scores.end(), rows.begin(), rows.end());
    }
    WriteScores(options.Folder + "/scores.csv", contents.Scores);
  }
  contents.Renderer = studio.GetRendererName();
  WriteGalleryPage(options.Folder, contents);
  Progress::Say(std::to_string(studio.GetNumberOfPicturesDrawn()) + " pictures drawn; open " +
    options.Folder + "/index.html");
}
}

void AddGalleryCommand(CLI::App& program)
{
  const auto options = std::make_shared<GalleryOptions>();
  CLI::App* command = program.add_subcommand(
    "gallery", "Draw the gallery: a CT cranium and test fields by all models, with times and scores");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--cranium", options->Cranium, "CT of the cranium (.inv3)")->capture_default_str();
  command->add_flag("--without-cranium", options->WithoutCranium, "Synthetic fields only");
  command->add_option("--only", options->Only, "Only sections whose title contains this text");
  command->add_flag("--without-scores", options->WithoutScores, "Leave out the table of scores");
  command
    ->add_option("--score-rule", options->ScoreRules,
      "How the scores match the models' glossiness and brightness, one or more (docs/scores.md)")
    ->check(CLI::IsMember(ScoreRules()))
    ->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->add_option("--trace", options->TraceFolder,
    "Write the pictures that are kept, not drawn, to this folder instead: minutes of rays in double");
  command->add_flag("--force", options->Force, "Draw also what was drawn with the same settings");
  command->callback([options] { MakeGallery(*options); });
}
