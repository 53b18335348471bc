// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics view: a window to turn the volume in.

#include "Commands.h"
#include "Lighting.h"
#include "PictureOptions.h"
#include "SideBySide.h"
#include "UserError.h"
#include "VolumeScene.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include <memory>

namespace
{
constexpr double InteractiveRate = 15.0; // frames per second wanted while the mouse moves
constexpr int GuessedBoundaries = 4;
const char* const NoFile = "-"; // the editor begins with a guess

struct ViewOptions : PictureOptions
{
  std::string EditedFile; // --lighting: NoFile or a file's name
  std::string WrittenFunction;

  CLI::Option* AddLightingFile(CLI::App& command) override
  {
    return command.add_flag("--lighting{-}", this->EditedFile,
      "Lighting transfer function with its editor beside the volume, guessed from the data or, as "
      "--lighting=FILE.json, from a file");
  }
};

void Run(VolumeScene& scene, vtkRenderWindowInteractor* interactor)
{
  interactor->SetDesiredUpdateRate(InteractiveRate);
  interactor->Initialize();
  scene.GetWindow()->Render();
  interactor->Start();
}

void View(ViewOptions& options)
{
  if (OffScreenWindow(false) == WindowKind::Headless)
  {
    throw UserError("There is no display to open a window on. Set DISPLAY, or use 'volumeoptics render'.");
  }
  options.LightingFile = options.EditedFile == NoFile ? "" : options.EditedFile;
  const Volume volume = options.Load();
  VolumeScene scene(volume, WindowKind::Visible);
  scene.Apply(options.Picture);
  scene.GetMapper()->AutoAdjustSampleDistancesOn();
  // Noise in place of contour lines where steps are coarse; but light on boundaries alone differs so much
  // from sample to sample that the noise would hide the surface.
  scene.GetMapper()->SetUseJittering(options.EditedFile.empty());
  scene.GetWindow()->SetWindowName(("volumeoptics: " + volume.Name).c_str());
  const vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.GetWindow());
  if (options.EditedFile.empty())
  {
    const vtkNew<vtkInteractorStyleTrackballCamera> style;
    interactor->SetInteractorStyle(style);
    Run(scene, interactor);
    return;
  }
  SideBySide view(scene, volume, options.Picture.Lighting, GuessedBoundaries);
  view.Connect(interactor, InteractiveRate);
  Run(scene, interactor);
  if (!options.WrittenFunction.empty())
  {
    WriteLighting(scene.GetProperty()->GetLightingTransferFunction(), options.WrittenFunction);
  }
}
}

void AddViewCommand(CLI::App& program)
{
  const auto options = std::make_shared<ViewOptions>();
  CLI::App* command = program.add_subcommand("view", "Open a window with the volume");
  options->AddTo(*command);
  command
    ->add_option(
      "--write-lighting", options->WrittenFunction, "Write the edited function when the window closes (JSON)")
    ->group("Lighting transfer function")
    ->needs("--lighting");
  command->callback([options] { View(*options); });
}
