// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SweepGrid.h"

#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Of the window's width, on each side.
const double Margin = 0.25;

// Corners of a box that an edge joins: those whose numbers differ in one bit.
template <typename Function>
void ForEachEdge(Function function)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int bit = 1; bit < 8; bit *= 2)
    {
      if ((corner & bit) == 0)
      {
        function(corner, corner | bit);
      }
    }
  }
}

void ToView(const double matrix[16], const double corners[24], double inView[24])
{
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2], 1.0 };
    vtkMatrix4x4::MultiplyPoint(matrix, point, point);
    std::copy(point, point + 3, inView + 3 * corner);
  }
}

// The part of an edge within the range of z, as parameters; false: none of it is.
bool ClipEdge(const double* from, const double* to, const double range[2], double part[2])
{
  part[0] = 0.0;
  part[1] = 1.0;
  const double change = to[2] - from[2];
  if (change == 0.0)
  {
    return from[2] >= range[0] && from[2] <= range[1];
  }
  const double first = (range[0] - from[2]) / change;
  const double second = (range[1] - from[2]) / change;
  part[0] = std::max(part[0], std::min(first, second));
  part[1] = std::min(part[1], std::max(first, second));
  return part[0] <= part[1];
}
}

//------------------------------------------------------------------------------
SweepGrid::SweepGrid(const View& view, const double corners[24], const Resolution& resolution)
  : IsPerspective(view.IsPerspective)
{
  std::copy(view.WorldToView, view.WorldToView + 16, this->WorldToView);
  if (this->SetDepths(view, corners) && this->SetWindow(view, corners))
  {
    this->Divide(resolution);
  }
}

//------------------------------------------------------------------------------
bool SweepGrid::operator==(const SweepGrid& other) const
{
  return std::equal(this->WorldToView, this->WorldToView + 16, other.WorldToView) &&
    this->IsPerspective == other.IsPerspective && std::equal(this->Window, this->Window + 4, other.Window) &&
    this->Begin == other.Begin && this->End == other.End &&
    std::equal(this->Size, this->Size + 3, other.Size);
}

//------------------------------------------------------------------------------
void SweepGrid::FindDepths(const double corners[24], double range[2]) const
{
  double inView[24];
  ToView(this->WorldToView, corners, inView);
  range[0] = std::numeric_limits<double>::max();
  range[1] = -std::numeric_limits<double>::max();
  for (int corner = 0; corner < 8; ++corner)
  {
    range[0] = std::min(range[0], inView[3 * corner + 2]);
    range[1] = std::max(range[1], inView[3 * corner + 2]);
  }
}

//------------------------------------------------------------------------------
bool SweepGrid::SetDepths(const View& view, const double corners[24])
{
  double range[2];
  this->FindDepths(corners, range);
  this->Begin = std::max(range[0], view.Range[0]);
  this->End = std::min(range[1], view.Range[1]);
  return this->Begin < this->End;
}

//------------------------------------------------------------------------------
// The box's edges there, and where they are cut.
bool SweepGrid::FindOutline(const double corners[24], const double range[2], double outline[4]) const
{
  double inView[24];
  ToView(this->WorldToView, corners, inView);
  outline[0] = outline[2] = std::numeric_limits<double>::max();
  outline[1] = outline[3] = -std::numeric_limits<double>::max();
  ForEachEdge([&](int first, int second) {
    const double* from = inView + 3 * first;
    const double* to = inView + 3 * second;
    double part[2];
    if (!ClipEdge(from, to, range, part))
    {
      return;
    }
    for (const double at : part)
    {
      const double z = from[2] + at * (to[2] - from[2]);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double place = (from[axis] + at * (to[axis] - from[axis])) / this->GetWidth(z);
        outline[2 * axis] = std::min(outline[2 * axis], place);
        outline[2 * axis + 1] = std::max(outline[2 * axis + 1], place);
      }
    }
  });
  return outline[0] <= outline[1];
}

//------------------------------------------------------------------------------
bool SweepGrid::SetWindow(const View& view, const double corners[24])
{
  const double range[2] = { this->Begin, this->End };
  double box[4];
  if (!this->FindOutline(corners, range, box))
  {
    return false;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const double margin = Margin * (view.Window[2 * axis + 1] - view.Window[2 * axis]);
    this->Window[2 * axis] = std::max(box[2 * axis], view.Window[2 * axis] - margin);
    this->Window[2 * axis + 1] = std::min(box[2 * axis + 1], view.Window[2 * axis + 1] + margin);
  }
  return this->Window[0] < this->Window[1] && this->Window[2] < this->Window[3];
}

//------------------------------------------------------------------------------
// Froxels are squares: the shorter side of the window grows to whole ones. Around a volume is a ring of one froxel in
// which nothing is: beyond the grid it is as on its outermost froxels.
void SweepGrid::Divide(const Resolution& resolution)
{
  const double sides[2] = { this->Window[1] - this->Window[0], this->Window[3] - this->Window[2] };
  const int size = std::clamp(resolution.Size, 1, resolution.LargestSize);
  const int ring = size > 2 ? 2 : 0;
  const double froxel = std::max(sides[0], sides[1]) / (size - ring);
  for (int axis = 0; axis < 2; ++axis)
  {
    const int froxels = static_cast<int>(std::ceil(sides[axis] / froxel - 1.0e-6));
    this->Size[axis] = std::clamp(froxels + ring, 1, size);
    const double growth = 0.5 * (this->Size[axis] * froxel - sides[axis]);
    this->Window[2 * axis] -= growth;
    this->Window[2 * axis + 1] += growth;
  }
  const double middle = this->GetWidth(0.5 * (this->Begin + this->End));
  const double wanted = (this->End - this->Begin) / (resolution.SliceDistance * froxel * middle);
  this->Size[2] = static_cast<int>(std::clamp(std::ceil(wanted - 1.0e-6), 1.0, 1.0 * resolution.LargestSize));
  this->SliceDistance = (this->End - this->Begin) / this->Size[2];
}

//------------------------------------------------------------------------------
void SweepGrid::GetWorldToTexture(double matrix[16], bool isInMiddle) const
{
  const double sides[2] = { this->Window[1] - this->Window[0], this->Window[3] - this->Window[2] };
  const double depth = this->IsEmpty() ? 1.0 : this->Size[2] * this->SliceDistance;
  double viewToTexture[16] = {};
  for (int axis = 0; axis < 2; ++axis)
  {
    viewToTexture[4 * axis + axis] = 1.0 / sides[axis];
    viewToTexture[4 * axis + (this->IsPerspective ? 2 : 3)] = -this->Window[2 * axis] / sides[axis];
  }
  viewToTexture[10] = 1.0 / depth;
  // the middle of a layer is what reaches the front of a slice, or its middle
  viewToTexture[11] = -(this->Begin + (isInMiddle ? 0.0 : 0.5 * this->SliceDistance)) / depth;
  viewToTexture[this->IsPerspective ? 14 : 15] = 1.0;
  vtkMatrix4x4::Multiply4x4(viewToTexture, this->WorldToView, matrix);
}
