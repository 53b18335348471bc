// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLightingTransferFunctionItem.h"

#include "HistogramPicture.h"
#include "LightingEditorPainter.h"
#include "ParameterRange.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkContext2D.h"
#include "vtkContextKeyEvent.h"
#include "vtkContextMouseEvent.h"
#include "vtkContextScene.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkLightingTransferFunctionItem);

namespace
{
// Pixels.
const float Margin = 6.0F;
const float TitleHeight = 16.0F;
const float TickSpace = 18.0F;  // for numbers under a horizontal axis
const float TickWidth = 36.0F;  // beside a vertical one
const float HalfNumber = 14.0F; // of a number at the end of an axis
const float LeastPlot = 8.0F;
const float HistogramShare = 0.36F; // of the width

const int GuessedBoundaries = 4;

struct Panels
{
  vtkRectf All;
  vtkRectf Lines; // with axes
  vtkRectf Gradients;
  vtkRectf Pairs;
};

Panels Split(const vtkRectf& all, bool withHistograms)
{
  const float side = withHistograms ? HistogramShare * all.GetWidth() : 0.0F;
  const float half = 0.5F * all.GetHeight();
  const float left = all.GetX() + all.GetWidth() - side;
  const auto histogram = [&](float bottom) {
    return vtkRectf(left, bottom + Margin, std::max(side - Margin, 1.0F),
      std::max(half - TitleHeight - 2.0F * Margin, 1.0F));
  };
  return { all, vtkRectf(all.GetX(), all.GetY(), all.GetWidth() - side, all.GetHeight()),
    histogram(all.GetY() + half), histogram(all.GetY()) };
}

vtkRectf PlotOf(const vtkRectf& panel, bool vertical, float thickness)
{
  const float acrossStart = (vertical ? TickWidth : TickSpace) + thickness;
  const float alongStart = Margin + (vertical ? 0.0F : HalfNumber);
  const float x = vertical ? acrossStart : alongStart;
  // the status below, the titles above
  const float y = TitleHeight + (vertical ? alongStart : acrossStart);
  const float top = TitleHeight + (vertical ? Margin : acrossStart);
  return vtkRectf(panel.GetX() + x, panel.GetY() + y, std::max(panel.GetWidth() - 2.0F * x, LeastPlot),
    std::max(panel.GetHeight() - y - top, LeastPlot));
}
}

class vtkLightingTransferFunctionItem::Internals
{
public:
  volumeoptics::LightingEditor Editor;
  vtkSmartPointer<vtkImageData> Histogram;
  vtkSmartPointer<vtkImageData> GradientHistogram;
  vtkSmartPointer<vtkPiecewiseFunction> Opacity;
  Panels Layout;
  vtkSmartPointer<vtkImageData> Lines;
  vtkSmartPointer<vtkImageData> Gradients;
  vtkSmartPointer<vtkImageData> Pairs;
  vtkTimeStamp SettingsTime; // of what the pictures depend on
  vtkTimeStamp PictureTime;
  vtkVector2i PictureSize = vtkVector2i(0, 0);
  vtkNew<vtkCallbackCommand> Observer;
};

//------------------------------------------------------------------------------
vtkLightingTransferFunctionItem::vtkLightingTransferFunctionItem()
  : Internal(std::make_unique<Internals>())
{
  this->Internal->Observer->SetClientData(this);
  this->Internal->Observer->SetCallback([](vtkObject*, unsigned long, void* item, void*) {
    static_cast<vtkLightingTransferFunctionItem*>(item)->Redraw();
  });
}

//------------------------------------------------------------------------------
vtkLightingTransferFunctionItem::~vtkLightingTransferFunctionItem()
{
  if (vtkLightingTransferFunction* function = this->Internal->Editor.GetFunction())
  {
    function->RemoveObserver(this->Internal->Observer);
  }
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::Redraw()
{
  this->Modified();
  if (this->Scene)
  {
    this->Scene->SetDirty(true);
  }
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::RedrawPictures()
{
  this->Internal->SettingsTime.Modified();
  this->Redraw();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetLightingTransferFunction(vtkLightingTransferFunction* function)
{
  vtkLightingTransferFunction* former = this->Internal->Editor.GetFunction();
  if (former == function)
  {
    return;
  }
  if (former)
  {
    former->RemoveObserver(this->Internal->Observer);
  }
  this->Internal->Editor.SetFunction(function);
  if (function)
  {
    function->AddObserver(vtkCommand::ModifiedEvent, this->Internal->Observer);
  }
  this->Redraw();
}

//------------------------------------------------------------------------------
vtkLightingTransferFunction* vtkLightingTransferFunctionItem::GetLightingTransferFunction()
{
  return this->Internal->Editor.GetFunction();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetHistogram(vtkImageData* histogram)
{
  this->Internal->Histogram = histogram;
  this->UpdateLayout();
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
vtkImageData* vtkLightingTransferFunctionItem::GetHistogram()
{
  return this->Internal->Histogram;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetGradientHistogram(vtkImageData* histogram)
{
  this->Internal->GradientHistogram = histogram;
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
vtkImageData* vtkLightingTransferFunctionItem::GetGradientHistogram()
{
  return this->Internal->GradientHistogram;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetOpacityFunction(vtkPiecewiseFunction* opacity)
{
  this->Internal->Opacity = opacity;
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkLightingTransferFunctionItem::GetOpacityFunction()
{
  return this->Internal->Opacity;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetOpacityTolerance(double tolerance)
{
  volumeoptics::SetWithinRange(this, "OpacityTolerance", tolerance, 0.0, 1.0, this->OpacityTolerance);
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetLogScale(bool log)
{
  this->LogScale = log;
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetVerticalAxes(bool vertical)
{
  this->VerticalAxes = vertical;
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetShowHistograms(bool show)
{
  this->ShowHistograms = show;
  this->Redraw();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetRectangle(double x, double y, double width, double height)
{
  const double rectangle[] = { x, y, width, height };
  std::copy(rectangle, rectangle + 4, this->Rectangle);
  this->Redraw();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetSelectedBoundary(int boundary)
{
  this->Internal->Editor.Select(std::max(boundary, -1));
  this->Redraw();
}

//------------------------------------------------------------------------------
int vtkLightingTransferFunctionItem::GetSelectedBoundary()
{
  return this->Internal->Editor.GetSelected();
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::Undo()
{
  return this->Internal->Editor.Undo();
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::Redo()
{
  return this->Internal->Editor.Redo();
}

//------------------------------------------------------------------------------
int vtkLightingTransferFunctionItem::InitializeFromHistogram(int number)
{
  return this->Internal->Editor.Guess(this->Internal->Histogram, number);
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::GetAxisPoint(int axis, double scalar, double point[2])
{
  const vtkVector2f pixel = this->Internal->Editor.Layout.Point(axis == 0 ? 0.0 : 1.0, scalar);
  point[0] = pixel.GetX();
  point[1] = pixel.GetY();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::GetBoundaryColor(int boundary, double color[3])
{
  const auto bytes = volumeoptics::BoundaryColor(std::max(boundary, 0));
  std::transform(bytes.begin(), bytes.end(), color, [](unsigned char byte) { return byte / 255.0; });
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::UpdateLayout()
{
  vtkRectf all(static_cast<float>(this->Rectangle[0]), static_cast<float>(this->Rectangle[1]),
    static_cast<float>(this->Rectangle[2]), static_cast<float>(this->Rectangle[3]));
  if (this->Scene && !(all.GetWidth() > 0.0F && all.GetHeight() > 0.0F))
  {
    all = vtkRectf(0.0F, 0.0F, static_cast<float>(this->Scene->GetSceneWidth()),
      static_cast<float>(this->Scene->GetSceneHeight()));
  }
  this->Internal->Layout = Split(all, this->ShowHistograms);
  volumeoptics::LightingEditorLayout& layout = this->Internal->Editor.Layout;
  layout.VerticalAxes = this->VerticalAxes;
  layout.Plot = PlotOf(this->Internal->Layout.Lines, this->VerticalAxes, layout.AxisThickness);
  layout.Range[0] = 0.0;
  layout.Range[1] = 1.0;
  vtkImageData* histogram = this->Internal->Histogram;
  if (histogram && histogram->GetNumberOfPoints() > 0 && histogram->GetSpacing()[0] > 0.0)
  {
    const double bin = histogram->GetSpacing()[0];
    const double first = histogram->GetOrigin()[0] + bin * histogram->GetExtent()[0];
    layout.Range[0] = first - 0.5 * bin;
    layout.Range[1] = first + (histogram->GetDimensions()[0] - 0.5) * bin;
  }
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::UpdatePictures()
{
  const volumeoptics::LightingEditorLayout& layout = this->Internal->Editor.Layout;
  const vtkVector2i size(static_cast<int>(layout.Length()), static_cast<int>(layout.Gap()));
  vtkMTimeType newest = this->Internal->SettingsTime;
  for (vtkObject* object : { static_cast<vtkObject*>(this->Internal->Histogram),
         static_cast<vtkObject*>(this->Internal->GradientHistogram),
         static_cast<vtkObject*>(this->Internal->Opacity) })
  {
    newest = object ? std::max(newest, object->GetMTime()) : newest;
  }
  if (this->Internal->Lines && size == this->Internal->PictureSize && newest < this->Internal->PictureTime)
  {
    return;
  }
  this->Internal->PictureSize = size;
  this->Internal->PictureTime.Modified();
  this->Internal->Lines = volumeoptics::LineHistogramPicture(this->Internal->Histogram, size.GetX(),
    size.GetY(), { this->LogScale, this->Internal->Opacity, this->OpacityTolerance });
  if (this->VerticalAxes)
  {
    this->Internal->Lines = volumeoptics::Transposed(this->Internal->Lines);
  }
  const vtkRectf& side = this->Internal->Layout.Pairs;
  const int width = static_cast<int>(side.GetWidth());
  const int height = static_cast<int>(side.GetHeight());
  this->Internal->Gradients =
    volumeoptics::HistogramPicture(this->Internal->GradientHistogram, width, height, this->LogScale);
  this->Internal->Pairs =
    volumeoptics::HistogramPicture(this->Internal->Histogram, width, height, this->LogScale);
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::Paint(vtkContext2D* context)
{
  this->UpdateLayout();
  this->UpdatePictures();
  const Internals& internal = *this->Internal;
  const volumeoptics::LightingEditorPainter painter(context, internal.Editor);
  const vtkRectf& lines = internal.Layout.Lines;
  painter.DrawBackground(internal.Layout.All);
  painter.DrawPicture(internal.Editor.Layout.Plot, internal.Lines);
  painter.DrawAxes();
  painter.DrawBoundaries();
  painter.DrawTrace();
  painter.DrawStatus(lines.GetX() + Margin, lines.GetY() + 0.5F * TitleHeight);
  const float title = lines.GetY() + lines.GetHeight() - 0.5F * TitleHeight;
  painter.DrawText(
    this->VerticalAxes ? "S2 downhill (left), S1 uphill (right)" : "S2 downhill (above), S1 uphill (below)",
    lines.GetX() + 0.5F * lines.GetWidth(), title);
  if (this->ShowHistograms)
  {
    const vtkRectf* const rectangles[] = { &internal.Layout.Gradients, &internal.Layout.Pairs };
    const char* const titles[] = { "scalar, gradient", "S1, S2" };
    for (int i = 0; i < 2; ++i)
    {
      const vtkRectf& panel = *rectangles[i];
      painter.DrawPicture(panel, i == 0 ? internal.Gradients : internal.Pairs);
      painter.DrawText(titles[i], panel.GetX() + 0.5F * panel.GetWidth(),
        panel.GetY() + panel.GetHeight() + 0.5F * TitleHeight);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::Hit(const vtkContextMouseEvent& mouse)
{
  const vtkRectf& all = this->Internal->Layout.All;
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
  const std::string name = symbol;
  const bool wasDragging = this->Internal->Editor.IsDragging();
  bool isKnown = true;
  if (name == "g")
  {
    this->SetLogScale(!this->LogScale);
  }
  else if (name == "h")
  {
    this->SetShowHistograms(!this->ShowHistograms);
  }
  else if (name == "i")
  {
    this->InitializeFromHistogram(GuessedBoundaries);
  }
  else
  {
    isKnown =
      this->Internal->Editor.Key(name, interactor->GetControlKey() != 0, interactor->GetShiftKey() != 0);
  }
  if (wasDragging && !this->Internal->Editor.IsDragging())
  {
    this->InvokeEvent(vtkCommand::EndInteractionEvent);
  }
  this->Redraw();
  return isKnown;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightingTransferFunction: " << this->GetLightingTransferFunction() << "\n";
  os << indent << "Histogram: " << this->GetHistogram() << "\n";
  os << indent << "GradientHistogram: " << this->GetGradientHistogram() << "\n";
  os << indent << "OpacityFunction: " << this->GetOpacityFunction() << "\n";
  os << indent << "OpacityTolerance: " << this->OpacityTolerance << "\n";
  os << indent << "LogScale: " << (this->LogScale ? "on" : "off") << "\n";
  os << indent << "VerticalAxes: " << (this->VerticalAxes ? "on" : "off") << "\n";
  os << indent << "ShowHistograms: " << (this->ShowHistograms ? "on" : "off") << "\n";
  os << indent << "Rectangle: " << this->Rectangle[0] << ", " << this->Rectangle[1] << ", "
     << this->Rectangle[2] << ", " << this->Rectangle[3] << "\n";
  os << indent << "SelectedBoundary: " << this->GetSelectedBoundary() << "\n";
}
