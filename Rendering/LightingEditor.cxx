// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingEditor.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace volumeoptics
{
namespace
{
// Pixels.
const float EndReach = 4.0F;
const float Slack = 3.0F;
const float LeastTrace = 0.3F; // share of the way between the axes
// Shares of the range of scalars.
const double NewHalfWidth = 0.04;
const double NewSoftness = 0.02;
const double FineStep = 1.0 / 256.0;
const double CoarseStep = 1.0 / 32.0;
const double CoefficientStep = 0.05;
const LightingCoefficients NewCoefficients = { 0.2, 0.7, 0.4 };

double Middle(vtkLightingTransferFunction* function, int boundary, int side)
{
  double range[2];
  function->GetRange(boundary, side, range);
  return 0.5 * (range[0] + range[1]);
}
}

void LightingEditor::SetFunction(vtkLightingTransferFunction* function)
{
  this->Function = function;
  this->History.Clear();
  this->Cancel();
  this->Selected = -1;
}

int LightingEditor::GetSelected() const
{
  // the function may have been edited elsewhere
  return this->Function && this->Selected < this->Function->GetNumberOfBoundaries() ? this->Selected : -1;
}

void LightingEditor::Select(int boundary)
{
  this->Selected = boundary;
  this->Side = 0;
}

int LightingEditor::SideOnS1(int boundary) const
{
  if (this->Pressed.Boundary == boundary && this->IsDragging())
  {
    return this->FrozenSideOnS1;
  }
  return Middle(this->Function, boundary, 0) > Middle(this->Function, boundary, 1) ? 0 : 1;
}

bool LightingEditor::IsMovable(int boundary, int side) const
{
  return !this->Function->GetCurve(boundary, side);
}

LightingEditor::Target LightingEditor::FindOnAxes(const vtkVector2f& pixel) const
{
  const double across = this->Layout.AcrossAt(pixel);
  const double strip = (this->Layout.AxisThickness + Slack) / std::max(this->Layout.Gap(), 1.0F);
  const bool onS1 = across <= 0.0 && across >= -strip;
  const bool onS2 = across >= 1.0 && across <= 1.0 + strip;
  const float along = this->Layout.VerticalAxes ? pixel.GetY() : pixel.GetX();
  const int count = onS1 || onS2 ? this->Function->GetNumberOfBoundaries() : 0;
  for (int i = count; i >= 0; --i)
  {
    // the selected one first, then the last ones, which are drawn above the others
    const int boundary = i == count ? this->GetSelected() : i;
    if (boundary < 0)
    {
      continue;
    }
    const int side = onS1 ? this->SideOnS1(boundary) : 1 - this->SideOnS1(boundary);
    double range[2];
    this->Function->GetRange(boundary, side, range);
    const float low =
      this->Layout.PixelOf(std::clamp(range[0], this->Layout.Range[0], this->Layout.Range[1]));
    const float high =
      this->Layout.PixelOf(std::clamp(range[1], this->Layout.Range[0], this->Layout.Range[1]));
    if (along < low - EndReach || along > high + EndReach)
    {
      continue;
    }
    const bool isLow = std::abs(along - low) <= EndReach && along - low <= high - along;
    const bool isHigh = std::abs(along - high) <= EndReach;
    return { isLow ? LowEnd : isHigh ? HighEnd : Box, boundary, side };
  }
  return {};
}

LightingEditor::Target LightingEditor::FindBand(const vtkVector2f& pixel) const
{
  const double across = this->Layout.AcrossAt(pixel);
  const double scalar = this->Layout.ScalarAt(pixel);
  if (across < 0.0 || across > 1.0)
  {
    return {};
  }
  const int boundary = this->GetSelected(); // the others' bands are no handles: lines can start there
  if (boundary >= 0)
  {
    const int side = this->SideOnS1(boundary);
    double ends[2][2];
    this->Function->GetRange(boundary, side, ends[AxisOfS1]);
    this->Function->GetRange(boundary, 1 - side, ends[AxisOfS2]);
    const double low = ends[AxisOfS1][0] + across * (ends[AxisOfS2][0] - ends[AxisOfS1][0]);
    const double high = ends[AxisOfS1][1] + across * (ends[AxisOfS2][1] - ends[AxisOfS1][1]);
    if (scalar >= low && scalar <= high)
    {
      return { Band, boundary, side };
    }
  }
  return {};
}

LightingEditor::Target LightingEditor::Find(const vtkVector2f& pixel) const
{
  const float along = this->Layout.VerticalAxes ? pixel.GetY() : pixel.GetX();
  const double across = this->Layout.AcrossAt(pixel);
  const double strip = (this->Layout.AxisThickness + Slack) / std::max(this->Layout.Gap(), 1.0F);
  const bool isInside = along >= this->Layout.Start() - EndReach &&
    along <= this->Layout.Start() + this->Layout.Length() + EndReach && across >= -strip &&
    across <= 1.0 + strip;
  if (!this->Function || !isInside)
  {
    return {};
  }
  Target target = this->FindOnAxes(pixel);
  target = target.Part == Nothing ? this->FindBand(pixel) : target;
  target.Part = target.Part == Nothing ? Plot : target.Part;
  return target;
}

void LightingEditor::RememberRanges(int boundary)
{
  for (int side = 0; side < 2; ++side)
  {
    this->Function->GetRange(boundary, side, this->StartRanges[side].data());
  }
}

void LightingEditor::Press(const vtkVector2f& pixel)
{
  const Target target = this->Find(pixel);
  this->Trace = { pixel, pixel };
  this->IsRecorded = false;
  if (target.Boundary >= 0)
  {
    this->FrozenSideOnS1 = this->SideOnS1(target.Boundary);
    this->RememberRanges(target.Boundary);
    this->Selected = target.Boundary;
    this->Side = target.Side;
  }
  this->Pressed = target;
}

void LightingEditor::Drag(const vtkVector2f& pixel)
{
  this->Trace[1] = pixel;
  const auto [part, boundary, pressedSide] = this->Pressed;
  if (part == Nothing || part == Plot || boundary >= this->Function->GetNumberOfBoundaries())
  {
    return;
  }
  const double change = this->Layout.ScalarAt(pixel) - this->Layout.ScalarAt(this->Trace[0]);
  if (!this->IsRecorded && change != 0.0)
  {
    this->History.Record(this->Function);
    this->IsRecorded = true;
  }
  for (int side = 0; side < 2; ++side)
  {
    const std::array<double, 2>& start = this->StartRanges[side];
    if (this->IsMovable(boundary, side) && (part == Band || side == pressedSide))
    {
      this->Function->SetRange(boundary, side, start[0] + (part == HighEnd ? 0.0 : change),
        start[1] + (part == LowEnd ? 0.0 : change));
    }
  }
}

void LightingEditor::AddTraced()
{
  const double across[] = { this->Layout.AcrossAt(this->Trace[0]), this->Layout.AcrossAt(this->Trace[1]) };
  if (std::abs(across[1] - across[0]) < LeastTrace)
  {
    this->Selected = -1; // a click
    return;
  }
  const double first = this->Layout.ScalarAt(this->Trace[0]);
  const double slope = (this->Layout.ScalarAt(this->Trace[1]) - first) / (across[1] - across[0]);
  const double s1 = first - across[0] * slope;
  this->AddAround(s1, s1 + slope);
}

void LightingEditor::Release(const vtkVector2f& pixel)
{
  this->Drag(pixel);
  const bool isTraced = this->IsTracing();
  this->Pressed = {};
  if (isTraced)
  {
    this->AddTraced();
  }
}

void LightingEditor::Cancel()
{
  const bool isChanged = this->IsDragging() && this->IsRecorded;
  this->Pressed = {};
  if (isChanged)
  {
    this->Undo();
  }
}

void LightingEditor::AddAround(double s1, double s2)
{
  if (!this->Function)
  {
    return;
  }
  this->History.Record(this->Function);
  const double width = this->Layout.Range[1] - this->Layout.Range[0];
  const double centers[] = { std::clamp(s1, this->Layout.Range[0], this->Layout.Range[1]),
    std::clamp(s2, this->Layout.Range[0], this->Layout.Range[1]) };
  double ranges[2][2];
  for (int axis = 0; axis < 2; ++axis)
  {
    ranges[axis][0] = centers[axis] - NewHalfWidth * width;
    ranges[axis][1] = centers[axis] + NewHalfWidth * width;
  }
  this->Selected = this->Function->AddBoundary(
    ranges[AxisOfS2], ranges[AxisOfS1], NewCoefficients[0], NewCoefficients[1], NewCoefficients[2]);
  this->Function->SetSoftness(this->Selected, NewSoftness * width);
  this->Side = 0;
}

int LightingEditor::Guess(vtkImageData* histogram, int number)
{
  if (!this->Function || !histogram)
  {
    return 0;
  }
  this->History.Record(this->Function);
  this->Selected = -1;
  return this->Function->InitializeFromHistogram(histogram, number);
}

void LightingEditor::RemoveSelected()
{
  if (this->IsSelected())
  {
    this->History.Record(this->Function);
    this->Function->RemoveBoundary(this->Selected);
    this->Selected = -1;
  }
}

double LightingEditor::RangeWidth() const
{
  return this->Layout.Range[1] - this->Layout.Range[0];
}

void LightingEditor::ChangeSoftness(double steps)
{
  if (this->IsSelected())
  {
    this->History.Record(this->Function);
    const double softness =
      this->Function->GetSoftness(this->Selected) + steps * FineStep * this->RangeWidth();
    this->Function->SetSoftness(this->Selected, std::clamp(softness, 0.0, this->RangeWidth()));
  }
}

void LightingEditor::ChangeCoefficient(double change)
{
  this->History.Record(this->Function);
  LightingCoefficients k;
  this->Function->GetCoefficients(this->Selected, k.data());
  k[this->Coefficient] = std::clamp(k[this->Coefficient] + change, 0.0, 1.0);
  this->Function->SetCoefficients(this->Selected, k[0], k[1], k[2]);
}

void LightingEditor::Move(double scalars)
{
  if (this->IsMovable(this->Selected, this->Side))
  {
    this->History.Record(this->Function);
    this->RememberRanges(this->Selected);
    const std::array<double, 2>& range = this->StartRanges[this->Side];
    this->Function->SetRange(this->Selected, this->Side, range[0] + scalars, range[1] + scalars);
  }
}

void LightingEditor::Widen(double scalars)
{
  if (this->IsMovable(this->Selected, this->Side))
  {
    this->History.Record(this->Function);
    this->RememberRanges(this->Selected);
    const std::array<double, 2>& range = this->StartRanges[this->Side];
    const double change = std::max(scalars, 0.5 * (range[0] - range[1]));
    this->Function->SetRange(this->Selected, this->Side, range[0] - change, range[1] + change);
  }
}

bool LightingEditor::KeyOfSelected(const std::string& symbol, bool shift)
{
  const double step = (shift ? CoarseStep : FineStep) * this->RangeWidth();
  const std::map<std::string, void (*)(LightingEditor*, double)> keys = {
    { "Delete", [](LightingEditor* editor, double) { editor->RemoveSelected(); } },
    { "BackSpace", [](LightingEditor* editor, double) { editor->RemoveSelected(); } },
    { "Left", [](LightingEditor* editor, double length) { editor->Move(-length); } },
    { "Right", [](LightingEditor* editor, double length) { editor->Move(length); } },
    { "Up", [](LightingEditor* editor, double) { editor->ChangeCoefficient(CoefficientStep); } },
    { "Down", [](LightingEditor* editor, double) { editor->ChangeCoefficient(-CoefficientStep); } },
    { "bracketleft", [](LightingEditor* editor, double length) { editor->Widen(-length); } },
    { "bracketright", [](LightingEditor* editor, double length) { editor->Widen(length); } },
    { "braceleft", [](LightingEditor* editor, double length) { editor->Widen(-length); } },
    { "braceright", [](LightingEditor* editor, double length) { editor->Widen(length); } },
    { "plus", [](LightingEditor* editor, double) { editor->ChangeSoftness(1.0); } },
    { "minus", [](LightingEditor* editor, double) { editor->ChangeSoftness(-1.0); } },
    { "space", [](LightingEditor* editor, double) { editor->Side = 1 - editor->Side; } },
  };
  const auto key = keys.find(symbol);
  if (key == keys.end() || !this->IsSelected())
  {
    return false;
  }
  key->second(this, step);
  return true;
}

bool LightingEditor::Key(const std::string& symbol, bool control, bool shift)
{
  if (!this->Function)
  {
    return false;
  }
  if (symbol == "z" || symbol == "Z")
  {
    return shift && control ? this->Redo() : this->Undo();
  }
  if (symbol == "y")
  {
    return this->Redo();
  }
  if (symbol == "Escape")
  {
    this->Cancel();
    this->Selected = -1;
    return true;
  }
  if (symbol == "Tab")
  {
    const int count = this->Function->GetNumberOfBoundaries();
    this->Select(count > 0 ? (this->GetSelected() + 1) % count : -1);
    return true;
  }
  if (symbol == "c")
  {
    this->Coefficient = (this->Coefficient + 1) % 3;
    return true;
  }
  if (symbol == "a")
  {
    const double width = this->RangeWidth();
    this->AddAround(this->Layout.Range[0] + 0.75 * width, this->Layout.Range[0] + 0.25 * width);
    return true;
  }
  return this->KeyOfSelected(symbol, shift);
}

bool LightingEditor::Undo()
{
  return this->Function && this->History.Undo(this->Function);
}

bool LightingEditor::Redo()
{
  return this->Function && this->History.Redo(this->Function);
}
}
