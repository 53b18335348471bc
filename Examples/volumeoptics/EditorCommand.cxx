// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics editor: the picture of the editor of lighting transfer functions, without a display.

#include "Commands.h"
#include "Lighting.h"
#include "PictureOptions.h"
#include "Progress.h"
#include "SideBySide.h"
#include "VolumeScene.h"

#include "vtkLightingTransferFunction.h"
#include "vtkLightingTransferFunctionItem.h"
#include "vtkOpticsVolumeProperty.h"

#include <vtkRenderWindow.h>

#include <memory>

namespace
{
struct EditorOptions : PictureOptions
{
  std::string Output = "editor.png";
  std::string WrittenFunction;
  int Guesses = 4;
  bool WithVolume = false;
  bool WithHistograms = false;
  bool VerticalAxes = false;
  bool Linear = false;
};

void Draw(EditorOptions& options)
{
  const Volume volume = options.Load();
  VolumeScene scene(volume, OffScreenWindow(options.Headless));
  scene.Apply(options.Picture);
  SideBySide view(scene, volume, options.Picture.Lighting, options.Guesses);
  vtkLightingTransferFunctionItem* item = view.GetPane().GetItem();
  item->SetShowHistograms(options.WithHistograms);
  item->SetVerticalAxes(options.VerticalAxes);
  item->SetLogScale(!options.Linear);
  if (!options.WithVolume)
  {
    view.ShowEditorAlone();
  }
  scene.Render();
  scene.WritePng(options.Output);
  Progress::Say(options.Output + ": " +
    std::to_string(item->GetLightingTransferFunction()->GetNumberOfBoundaries()) + " boundaries");
  if (!options.WrittenFunction.empty())
  {
    WriteLighting(item->GetLightingTransferFunction(), options.WrittenFunction);
  }
}
}

void AddEditorCommand(CLI::App& program)
{
  const auto options = std::make_shared<EditorOptions>();
  CLI::App* command =
    program.add_subcommand("editor", "Draw the editor of lighting transfer functions into a PNG file");
  options->AddTo(*command);
  command->add_option("-o,--output", options->Output, "Picture to write (PNG)")->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command
    ->add_option(
      "--boundaries", options->Guesses, "Boundaries to guess from the histogram, at most, without --lighting")
    ->check(CLI::Range(0, 64))
    ->capture_default_str();
  command->add_option(
    "--write-lighting", options->WrittenFunction, "Write the lighting transfer function (JSON)");
  command->add_flag("--with-volume", options->WithVolume, "The volume beside, as 'view --lighting' shows it");
  command->add_flag("--histograms", options->WithHistograms, "The 2D histograms beside the lines");
  command->add_flag("--vertical-axes", options->VerticalAxes, "Axes upright, beside each other");
  command->add_flag("--linear", options->Linear, "Intensity in proportion to density, not its logarithm");
  command->callback([options] { Draw(*options); });
}
