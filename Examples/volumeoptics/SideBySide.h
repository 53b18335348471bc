// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A volume and the editor of its lighting transfer function in one window: each edit shows at once,
// in draft quality while the mouse drags.

#ifndef SideBySide_h
#define SideBySide_h

#include "Lighting.h"
#include "VolumeFile.h"

#include <vtkNew.h>

class VolumeScene;
class vtkContextInteractorStyle;
class vtkInteractorStyleTrackballCamera;
class vtkRenderWindowInteractor;

class SideBySide
{
public:
  // The scene has been given its settings; without boundaries some are guessed.
  SideBySide(VolumeScene& scene, const Volume& volume, const LightingSettings& lighting, int guesses);
  ~SideBySide();
  SideBySide(const SideBySide&) = delete;
  SideBySide& operator=(const SideBySide&) = delete;

  LightingPane& GetPane() { return this->Pane; }
  void ShowEditorAlone();

  // The mouse edits on the left and turns the volume on the right. rate: frames per second wanted while it
  // drags.
  void Connect(vtkRenderWindowInteractor* interactor, double rate);

private:
  void ChooseStyle();
  void SetDraft(bool isDraft);

  VolumeScene& Scene;
  LightingPane Pane;
  vtkNew<vtkContextInteractorStyle> EditorStyle;
  vtkNew<vtkInteractorStyleTrackballCamera> VolumeStyle;
  vtkRenderWindowInteractor* Interactor = nullptr;
  double DraftRate = 0.0;
  bool ButtonIsDown = false;
};

#endif
