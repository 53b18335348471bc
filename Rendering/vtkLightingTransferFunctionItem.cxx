// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLightingTransferFunctionItemInternals.h"

#include "LightingEditorPainter.h"
#include "ParameterRange.h"

#include "vtkCommand.h"
#include "vtkContext2D.h"
#include "vtkContextScene.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkLightingTransferFunctionItem);

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
  this->Internal->Pictures.SettingsTime.Modified();
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
  this->Internal->Pictures.Histogram = histogram;
  this->UpdateLayout();
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
vtkImageData* vtkLightingTransferFunctionItem::GetHistogram()
{
  return this->Internal->Pictures.Histogram;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetGradientHistogram(vtkImageData* histogram)
{
  this->Internal->Pictures.GradientHistogram = histogram;
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
vtkImageData* vtkLightingTransferFunctionItem::GetGradientHistogram()
{
  return this->Internal->Pictures.GradientHistogram;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunctionItem::SetOpacityFunction(vtkPiecewiseFunction* opacity)
{
  this->Internal->Pictures.Opacity = opacity;
  this->RedrawPictures();
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkLightingTransferFunctionItem::GetOpacityFunction()
{
  return this->Internal->Pictures.Opacity;
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
  return this->Internal->Editor.Guess(this->Internal->Pictures.Histogram, number);
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
  this->Internal->Panels = { all, this->ShowHistograms };
  volumeoptics::LightingEditorLayout& layout = this->Internal->Editor.Layout;
  layout.VerticalAxes = this->VerticalAxes;
  layout.Plot = this->Internal->Panels.Plot(this->VerticalAxes, layout.AxisThickness);
  layout.Range[0] = 0.0;
  layout.Range[1] = 1.0;
  vtkImageData* histogram = this->Internal->Pictures.Histogram;
  if (histogram && histogram->GetNumberOfPoints() > 0 && histogram->GetSpacing()[0] > 0.0)
  {
    const double bin = histogram->GetSpacing()[0];
    const double first = histogram->GetOrigin()[0] + bin * histogram->GetExtent()[0];
    layout.Range[0] = first - 0.5 * bin;
    layout.Range[1] = first + (histogram->GetDimensions()[0] - 0.5) * bin;
  }
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunctionItem::Paint(vtkContext2D* context)
{
  this->UpdateLayout();
  this->Internal->Pictures.Update(
    this->Internal->Editor.Layout, this->Internal->Panels.Pairs, this->LogScale, this->OpacityTolerance);
  const Internals& internal = *this->Internal;
  const volumeoptics::LightingEditorPainter painter(context, internal.Editor);
  const vtkRectf& lines = internal.Panels.Lines;
  painter.DrawBackground(internal.Panels.All);
  painter.DrawPicture(internal.Editor.Layout.Plot, internal.Pictures.GetLines());
  painter.DrawAxes();
  painter.DrawBoundaries();
  painter.DrawTrace();
  const float width = lines.GetWidth() - 2.0F * volumeoptics::PanelMargin;
  painter.DrawStatus(
    lines.GetX() + volumeoptics::PanelMargin, lines.GetY() + 0.5F * volumeoptics::TitleHeight, width);
  const float title = lines.GetY() + lines.GetHeight() - 0.5F * volumeoptics::TitleHeight;
  painter.DrawLongest(this->VerticalAxes
      ? std::vector<std::string>{ "S2 downhill (left), S1 uphill (right)", "left S2, right S1" }
      : std::vector<std::string>{ "S2 downhill (above), S1 uphill (below)", "above S2, below S1" },
    lines.GetX() + 0.5F * lines.GetWidth(), title, width);
  if (this->ShowHistograms)
  {
    const vtkRectf* const rectangles[] = { &internal.Panels.Gradients, &internal.Panels.Pairs };
    const char* const titles[] = { "scalar, gradient", "S1, S2" };
    for (int i = 0; i < 2; ++i)
    {
      const vtkRectf& panel = *rectangles[i];
      painter.DrawPicture(panel, i == 0 ? internal.Pictures.GetGradients() : internal.Pictures.GetPairs());
      painter.DrawLongest({ titles[i] }, panel.GetX() + 0.5F * panel.GetWidth(),
        panel.GetY() + panel.GetHeight() + 0.5F * volumeoptics::TitleHeight, panel.GetWidth());
    }
  }
  return true;
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
