// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The item's mouse and keyboard.

#include "vtkLightingTransferFunctionItemInternals.h"

#include "vtkCommand.h"
#include "vtkContextKeyEvent.h"
#include "vtkContextMouseEvent.h"
#include "vtkRenderWindowInteractor.h"

namespace
{
const int GuessedBoundaries = 4;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::Hit(const vtkContextMouseEvent& mouse)
{
  const vtkRectf& all = this->Internal->Panels.All;
  const vtkVector2f pixel = mouse.GetPos();
  return this->Interactive && this->Visible && pixel.GetX() >= all.GetX() && pixel.GetY() >= all.GetY() &&
    pixel.GetX() < all.GetX() + all.GetWidth() && pixel.GetY() < all.GetY() + all.GetHeight();
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::MouseButtonPressEvent(const vtkContextMouseEvent& mouse)
{
  if (mouse.GetButton() != vtkContextMouseEvent::LEFT_BUTTON)
  {
    return false;
  }
  this->Internal->Editor.Press(mouse.GetPos());
  if (this->Internal->Editor.IsDragging())
  {
    this->InvokeEvent(vtkCommand::StartInteractionEvent);
  }
  this->Redraw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::MouseMoveEvent(const vtkContextMouseEvent& mouse)
{
  if (!this->Internal->Editor.IsDragging())
  {
    return false;
  }
  this->Internal->Editor.Drag(mouse.GetPos());
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->Redraw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::MouseButtonReleaseEvent(const vtkContextMouseEvent& mouse)
{
  if (!this->Internal->Editor.IsDragging())
  {
    return false;
  }
  this->Internal->Editor.Release(mouse.GetPos());
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  this->Redraw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::MouseDoubleClickEvent(const vtkContextMouseEvent& mouse)
{
  volumeoptics::LightingEditor& editor = this->Internal->Editor;
  const bool isPlot = mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON &&
    editor.Find(mouse.GetPos()).Part == volumeoptics::LightingEditor::Plot;
  if (isPlot)
  {
    const double scalar = editor.Layout.ScalarAt(mouse.GetPos());
    editor.AddAround(scalar, scalar);
    this->Redraw();
  }
  return isPlot;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::MouseWheelEvent(const vtkContextMouseEvent&, int delta)
{
  this->Internal->Editor.ChangeSoftness(delta);
  this->Redraw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::KeyPressEvent(const vtkContextKeyEvent& key)
{
  vtkRenderWindowInteractor* interactor = key.GetInteractor();
  const char* symbol = interactor ? interactor->GetKeySym() : nullptr;
  if (!symbol)
  {
    return false;
  }
  volumeoptics::LightingEditor& editor = this->Internal->Editor;
  const bool wasDragging = editor.IsDragging();
  const bool isKnown = this->ViewKey(symbol) ||
    editor.Key(symbol, interactor->GetControlKey() != 0, interactor->GetShiftKey() != 0);
  if (wasDragging && !editor.IsDragging())
  {
    this->InvokeEvent(vtkCommand::EndInteractionEvent);
  }
  this->Redraw();
  return isKnown;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::ViewKey(const std::string& symbol)
{
  if (symbol == "g")
  {
    this->SetLogScale(!this->LogScale);
  }
  else if (symbol == "h")
  {
    this->SetShowHistograms(!this->ShowHistograms);
  }
  else if (symbol == "i")
  {
    this->InitializeFromHistogram(GuessedBoundaries);
  }
  else
  {
    return false;
  }
  return true;
}
