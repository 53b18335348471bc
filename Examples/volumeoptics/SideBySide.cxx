// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SideBySide.h"

#include "VolumeScene.h"

#include "vtkLightingTransferFunction.h"
#include "vtkLightingTransferFunctionItem.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include <vtkCallbackCommand.h>
#include <vtkContextInteractorStyle.h>
#include <vtkContextScene.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace
{
// Of the window's width. It begins at 0: the scene's pixels are the window's.
constexpr double EditorShare = 0.42;
constexpr float BeforeStyles = 10.0F; // priority

vtkLightingTransferFunction* FunctionOf(vtkOpticsVolumeProperty* property)
{
  if (!property->GetLightingTransferFunction())
  {
    const vtkNew<vtkLightingTransferFunction> function;
    property->SetLightingTransferFunction(function);
  }
  return property->GetLightingTransferFunction();
}
}

SideBySide::SideBySide(
  VolumeScene& scene, const Volume& volume, const LightingSettings& lighting, int guesses)
  : Scene(scene)
  , Pane(volume.Image, scene.GetProperty()->GetScalarOpacity(), FunctionOf(scene.GetProperty()),
      lighting.StepLength, guesses)
{
  this->Pane.GetRenderer()->SetViewport(0.0, 0.0, EditorShare, 1.0);
  this->Scene.GetRenderer()->SetViewport(EditorShare, 0.0, 1.0, 1.0);
  this->Scene.GetWindow()->AddRenderer(this->Pane.GetRenderer());
}

SideBySide::~SideBySide()
{
  this->EditorStyle->SetScene(nullptr);
}

void SideBySide::ShowEditorAlone()
{
  this->Scene.GetWindow()->RemoveRenderer(this->Scene.GetRenderer());
  this->Pane.GetRenderer()->SetViewport(0.0, 0.0, 1.0, 1.0);
}

// A still picture has the scene's own steps, where the mapper's choice would show contour lines.
void SideBySide::SetDraft(bool isDraft)
{
  this->Scene.GetMapper()->SetAutoAdjustSampleDistances(isDraft);
  this->Scene.GetWindow()->SetDesiredUpdateRate(
    isDraft ? this->DraftRate : this->Interactor->GetStillUpdateRate());
}

// By the renderer under the mouse, unless a button is held down: a drag stays with what it began on.
void SideBySide::ChooseStyle()
{
  const int* position = this->Interactor->GetEventPosition();
  const bool onEditor = position[0] < EditorShare * this->Scene.GetWindow()->GetSize()[0];
  vtkInteractorObserver* wanted = onEditor ? static_cast<vtkInteractorObserver*>(this->EditorStyle)
                                           : static_cast<vtkInteractorObserver*>(this->VolumeStyle);
  if (this->Interactor->GetInteractorStyle() != wanted)
  {
    this->Interactor->SetInteractorStyle(wanted);
    // a style without an interactor must not hear of its scene
    this->EditorStyle->SetScene(onEditor ? this->Pane.GetScene() : nullptr);
  }
}

void SideBySide::Connect(vtkRenderWindowInteractor* interactor, double rate)
{
  this->Interactor = interactor;
  this->DraftRate = rate;
  interactor->SetInteractorStyle(this->VolumeStyle);
  const vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long event, void* data, void*) {
    auto* self = static_cast<SideBySide*>(data);
    if (event == vtkCommand::StartInteractionEvent || event == vtkCommand::EndInteractionEvent)
    {
      self->SetDraft(event == vtkCommand::StartInteractionEvent);
    }
    else if (!self->ButtonIsDown)
    {
      self->ChooseStyle();
    }
    const bool isPress = event == vtkCommand::LeftButtonPressEvent ||
      event == vtkCommand::MiddleButtonPressEvent || event == vtkCommand::RightButtonPressEvent;
    const bool isRelease = event == vtkCommand::LeftButtonReleaseEvent ||
      event == vtkCommand::MiddleButtonReleaseEvent || event == vtkCommand::RightButtonReleaseEvent;
    self->ButtonIsDown = isPress || (self->ButtonIsDown && !isRelease);
  });
  for (const auto event : { vtkCommand::MouseMoveEvent, vtkCommand::KeyPressEvent,
         vtkCommand::LeftButtonPressEvent, vtkCommand::MiddleButtonPressEvent,
         vtkCommand::RightButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent })
  {
    interactor->AddObserver(event, command, BeforeStyles);
  }
  for (vtkObject* object :
    { static_cast<vtkObject*>(this->Pane.GetItem()), static_cast<vtkObject*>(this->VolumeStyle) })
  {
    object->AddObserver(vtkCommand::StartInteractionEvent, command);
    object->AddObserver(vtkCommand::EndInteractionEvent, command);
  }
  this->SetDraft(false);
}
