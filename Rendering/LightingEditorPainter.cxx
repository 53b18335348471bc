// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingEditorPainter.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkImageData.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstdio>

namespace volumeoptics
{
namespace
{
const int FontSize = 11;
const int LargestNumberOfTicks = 5;
const float LeastTickDistance = 44.0F; // room for a number
const float TickLength = 4.0F;
const float LeastBox = 4.0F; // pixels, so that it can be grabbed
const unsigned char BandOpacity = 60;
const unsigned char EdgeOpacity = 90; // of the soft edges

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}
}

std::array<unsigned char, 3> BoundaryColor(int boundary)
{
  static const std::array<unsigned char, 3> colors[] = { { 230, 159, 0 }, { 86, 180, 233 }, { 0, 158, 115 },
    { 240, 228, 66 }, { 213, 94, 0 }, { 204, 121, 167 }, { 148, 103, 189 }, { 0, 114, 178 } };
  return colors[boundary % 8];
}

void LightingEditorPainter::DrawBackground(const vtkRectf& rectangle) const
{
  this->Painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->Painter->GetBrush()->SetColor(24, 26, 32, 255);
  this->Painter->DrawRect(rectangle.GetX(), rectangle.GetY(), rectangle.GetWidth(), rectangle.GetHeight());
  this->Painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
}

void LightingEditorPainter::DrawPicture(const vtkRectf& rectangle, vtkImageData* picture) const
{
  this->Painter->GetPen()->SetColor(255, 255, 255, 255);
  this->Painter->DrawImage(rectangle, picture);
}

void LightingEditorPainter::SetFont() const
{
  vtkTextProperty* property = this->Painter->GetTextProp();
  property->SetFontFamilyToArial();
  property->SetFontSize(FontSize);
  property->SetColor(0.85, 0.87, 0.9);
}

void LightingEditorPainter::DrawText(const std::string& text, float x, float y, bool isLeft) const
{
  this->SetFont();
  vtkTextProperty* property = this->Painter->GetTextProp();
  property->SetJustification(isLeft ? VTK_TEXT_LEFT : VTK_TEXT_CENTERED);
  property->SetVerticalJustificationToCentered();
  this->Painter->DrawString(x, y, text.c_str());
}

void LightingEditorPainter::DrawAxes() const
{
  const LightingEditorLayout& layout = this->Editor.Layout;
  for (int axis = AxisOfS1; axis <= AxisOfS2; ++axis)
  {
    const double outward = (axis == AxisOfS1 ? -1.0 : 1.0) / std::max(layout.Gap(), 1.0F);
    const double edge = axis + outward * layout.AxisThickness;
    this->Painter->GetPen()->SetColor(150, 155, 165, 255);
    this->Painter->GetPen()->SetWidth(1.0F);
    for (const double across : { static_cast<double>(axis), edge })
    {
      const vtkVector2f first = layout.Point(across, layout.Range[0]);
      const vtkVector2f last = layout.Point(across, layout.Range[1]);
      this->Painter->DrawLine(first.GetX(), first.GetY(), last.GetX(), last.GetY());
    }
    const int intervals =
      std::clamp(static_cast<int>(layout.Length() / LeastTickDistance), 1, LargestNumberOfTicks - 1);
    for (int i = 0; i <= intervals; ++i)
    {
      const double scalar = layout.Range[0] + i * (layout.Range[1] - layout.Range[0]) / intervals;
      const vtkVector2f from = layout.Point(edge, scalar);
      const vtkVector2f to = layout.Point(edge + outward * TickLength, scalar);
      const vtkVector2f text = layout.Point(edge + outward * (layout.VerticalAxes ? 20.0 : 12.0), scalar);
      this->Painter->DrawLine(from.GetX(), from.GetY(), to.GetX(), to.GetY());
      this->DrawText(Number(scalar), text.GetX(), text.GetY());
    }
  }
}

void LightingEditorPainter::DrawBand(int boundary) const
{
  const LightingEditorLayout& layout = this->Editor.Layout;
  const int side = this->Editor.SideOnS1(boundary);
  double ends[2][2];
  this->Editor.GetFunction()->GetRange(boundary, side, ends[AxisOfS1]);
  this->Editor.GetFunction()->GetRange(boundary, 1 - side, ends[AxisOfS2]);
  for (auto& range : ends)
  {
    range[0] = std::clamp(range[0], layout.Range[0], layout.Range[1]);
    range[1] = std::clamp(range[1], layout.Range[0], layout.Range[1]);
  }
  const vtkVector2f corners[] = { layout.Point(0.0, ends[AxisOfS1][0]), layout.Point(0.0, ends[AxisOfS1][1]),
    layout.Point(1.0, ends[AxisOfS2][1]), layout.Point(1.0, ends[AxisOfS2][0]) };
  const auto color = BoundaryColor(boundary);
  const bool isSelected = boundary == this->Editor.GetSelected();
  this->Painter->GetBrush()->SetColor(
    color[0], color[1], color[2], isSelected ? 2 * BandOpacity : BandOpacity);
  this->Painter->GetPen()->SetColor(color[0], color[1], color[2], 255);
  this->Painter->GetPen()->SetWidth(isSelected ? 2.0F : 1.0F);
  this->Painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->Painter->DrawQuad(corners[0].GetX(), corners[0].GetY(), corners[1].GetX(), corners[1].GetY(),
    corners[2].GetX(), corners[2].GetY(), corners[3].GetX(), corners[3].GetY());
  this->Painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  this->Painter->DrawLine(corners[0].GetX(), corners[0].GetY(), corners[3].GetX(), corners[3].GetY());
  this->Painter->DrawLine(corners[1].GetX(), corners[1].GetY(), corners[2].GetX(), corners[2].GetY());
}

void LightingEditorPainter::DrawBox(int boundary, int axis) const
{
  const LightingEditorLayout& layout = this->Editor.Layout;
  const int side = axis == AxisOfS1 ? this->Editor.SideOnS1(boundary) : 1 - this->Editor.SideOnS1(boundary);
  double range[2];
  this->Editor.GetFunction()->GetRange(boundary, side, range);
  const bool isCurve = this->Editor.GetFunction()->GetCurve(boundary, side) != nullptr;
  const double softness = isCurve ? 0.0 : this->Editor.GetFunction()->GetSoftness(boundary);
  const bool isSelected = boundary == this->Editor.GetSelected();
  const auto color = BoundaryColor(boundary);
  const float outward = axis == AxisOfS1 ? -layout.AxisThickness : layout.AxisThickness;
  const auto draw = [&](double low, double high, unsigned char opacity) {
    const float first = layout.PixelOf(std::clamp(low, layout.Range[0], layout.Range[1]));
    const float last = layout.PixelOf(std::clamp(high, layout.Range[0], layout.Range[1]));
    const float width = std::max(last - first, LeastBox);
    const vtkVector2f corner = layout.Point(axis, layout.Range[0]);
    this->Painter->GetBrush()->SetColor(color[0], color[1], color[2], opacity);
    if (layout.VerticalAxes)
    {
      this->Painter->DrawRect(corner.GetX(), first, -outward, width);
    }
    else
    {
      this->Painter->DrawRect(first, corner.GetY(), width, outward);
    }
  };
  this->Painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  if (softness > 0.0)
  {
    draw(range[0] - softness, range[1] + softness, EdgeOpacity);
  }
  const bool isActive = isSelected && side == this->Editor.GetSelectedSide();
  this->Painter->GetPen()->SetLineType(isSelected ? vtkPen::SOLID_LINE : vtkPen::NO_PEN);
  this->Painter->GetPen()->SetColor(255, 255, 255, isActive ? 255 : 120);
  this->Painter->GetPen()->SetWidth(isActive ? 2.0F : 1.0F);
  draw(range[0], range[1], 235);
  this->Painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
}

void LightingEditorPainter::DrawBoundaries() const
{
  const int count = this->Editor.GetFunction() ? this->Editor.GetFunction()->GetNumberOfBoundaries() : 0;
  for (int i = 0; i < count; ++i)
  {
    this->DrawBand(i);
  }
  for (int i = 0; i <= count; ++i)
  {
    // the selected one last, above the others
    const int boundary = i < count ? i : this->Editor.GetSelected();
    for (int axis = AxisOfS1; axis <= AxisOfS2 && boundary >= 0; ++axis)
    {
      this->DrawBox(boundary, axis);
    }
  }
}

void LightingEditorPainter::DrawTrace() const
{
  if (this->Editor.IsTracing())
  {
    const std::array<vtkVector2f, 2>& trace = this->Editor.GetTrace();
    this->Painter->GetPen()->SetColor(255, 255, 255, 255);
    this->Painter->GetPen()->SetWidth(2.0F);
    this->Painter->DrawLine(trace[0].GetX(), trace[0].GetY(), trace[1].GetX(), trace[1].GetY());
  }
}

void LightingEditorPainter::DrawLongest(
  const std::vector<std::string>& texts, float x, float y, float width, bool isLeft) const
{
  for (const std::string& text : texts)
  {
    this->SetFont();
    float bounds[4]; // x, y, width, height
    this->Painter->ComputeStringBounds(text.c_str(), bounds);
    if (bounds[2] <= width)
    {
      this->DrawText(text, x, y, isLeft);
      return;
    }
  }
}

std::vector<std::string> LightingEditorPainter::Help() const
{
  const std::string draw = "Drag from axis to axis: new boundary";
  const std::string more = draw + "   click a box: select it";
  return { more + "   i: guess   h: histograms   z: undo", more + "   i: guess", draw,
    "Drag across: new boundary", "Drag across" };
}

std::vector<std::string> LightingEditorPainter::Coefficients(int boundary) const
{
  static const char* const names[] = { "ka", "kd", "ks" };
  LightingCoefficients k;
  this->Editor.GetFunction()->GetCoefficients(boundary, k.data());
  std::string text;
  for (int i = 0; i < 3; ++i)
  {
    const std::string value = std::string(names[i]) + " " + Number(k[i]);
    text += i == this->Editor.GetCoefficient() ? "[" + value + "]  " : value + "  ";
  }
  const std::string all = text + "soft " + Number(this->Editor.GetFunction()->GetSoftness(boundary));
  const std::string keys = "   (Up, Down: change   c: next";
  return { all + keys + "   +, -: soft   Delete: remove)", all + keys + ")", all, text };
}

void LightingEditorPainter::DrawStatus(float x, float y, float width) const
{
  const int boundary = this->Editor.GetSelected();
  this->DrawLongest(boundary < 0 ? this->Help() : this->Coefficients(boundary), x, y, width, true);
}
}
