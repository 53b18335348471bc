// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingEditor.h"

#include <algorithm>
#include <cmath>

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

// Of an axis, where boxes are, as a share of the gap.
double LightingEditor::StripWidth() const
{
  return (this->Layout.AxisThickness + Slack) / std::max(this->Layout.Gap(), 1.0F);
}

LightingEditor::PartType LightingEditor::PartOfBox(const double range[2], float along) const
{
  const float low = this->Layout.PixelOf(std::clamp(range[0], this->Layout.Range[0], this->Layout.Range[1]));
  const float high = this->Layout.PixelOf(std::clamp(range[1], this->Layout.Range[0], this->Layout.Range[1]));
  if (along < low - EndReach || along > high + EndReach)
  {
    return Nothing;
  }
  const bool isLow = std::abs(along - low) <= EndReach && along - low <= high - along;
  const bool isHigh = std::abs(along - high) <= EndReach;
  return isLow ? LowEnd : isHigh ? HighEnd : Box;
}

LightingEditor::Target LightingEditor::FindOnAxes(const vtkVector2f& pixel) const
{
  const double across = this->Layout.AcrossAt(pixel);
  const double strip = this->StripWidth();
  const bool onS1 = across <= 0.0 && across >= -strip;
  const bool onS2 = across >= 1.0 && across <= 1.0 + strip;
  const float along = this->Layout.AlongAt(pixel);
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
    const PartType part = this->PartOfBox(range, along);
    if (part != Nothing)
    {
      return { part, boundary, side };
    }
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
  const float along = this->Layout.AlongAt(pixel);
  const double across = this->Layout.AcrossAt(pixel);
  const double strip = this->StripWidth();
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

bool LightingEditor::Undo()
{
  return this->Function && this->History.Undo(this->Function);
}

bool LightingEditor::Redo()
{
  return this->Function && this->History.Redo(this->Function);
}
}
