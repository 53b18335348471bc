// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics render: one picture of one volume.

#include "Commands.h"
#include "PictureOptions.h"
#include "Progress.h"
#include "VolumeScene.h"

#include <vtkRenderWindow.h>

#include <memory>

namespace
{
struct RenderOptions : PictureOptions
{
  std::string Output = "out.png";
};

void Draw(RenderOptions& options)
{
  const Volume volume = options.Load();
  VolumeScene scene(volume, OffScreenWindow(options.Headless));
  scene.Apply(options.Picture);
  double first = 0.0;
  {
    Progress drawing("Rendering");
    scene.SetPreparationCallback(
      [&](double fraction) { drawing.Update(fraction, "normals and covariance"); });
    first = scene.Render();
  }
  scene.WritePng(options.Output);
  Progress::Say(options.Output + ": preparation " + TimeText(scene.GetPreparationSeconds()) +
    ", frame with set-up " + TimeText(first - scene.GetPreparationSeconds()));
}
}

void AddRenderCommand(CLI::App& program)
{
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "Draw a volume into a PNG file");
  options->AddTo(*command);
  command->add_option("-o,--output", options->Output, "Picture to write (PNG)")->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { Draw(*options); });
}
