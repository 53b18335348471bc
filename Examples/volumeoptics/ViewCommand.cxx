// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics view: a window to turn the volume in.

#include "Commands.h"
#include "PictureOptions.h"
#include "VolumeScene.h"
#include "UserError.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "vtkOpticsVolumeMapper.h"

#include <memory>

namespace
{
constexpr double InteractiveRate = 15.0; // frames per second wanted while the mouse moves

void View(PictureOptions& options)
{
  if (OffScreenWindow(false) == WindowKind::Headless)
  {
    throw UserError("There is no display to open a window on. Set DISPLAY, or use 'volumeoptics render'.");
  }
  const Volume volume = options.Load();
  VolumeScene scene(volume, WindowKind::Visible);
  scene.Apply(options.Picture);
  scene.GetMapper()->AutoAdjustSampleDistancesOn();
  scene.GetMapper()->UseJitteringOn(); // noise in place of contour lines where steps are coarse
  scene.GetWindow()->SetWindowName(("volumeoptics: " + volume.Name).c_str());
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(scene.GetWindow());
  interactor->SetDesiredUpdateRate(InteractiveRate);
  interactor->Initialize();
  scene.GetWindow()->Render();
  interactor->Start();
}
}

void AddViewCommand(CLI::App& program)
{
  const auto options = std::make_shared<PictureOptions>();
  CLI::App* command = program.add_subcommand("view", "Open a window with the volume");
  options->AddTo(*command);
  command->callback([options] { View(*options); });
}
