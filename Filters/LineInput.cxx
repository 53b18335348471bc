// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumeoptics
{
LineInput::LineInput(vtkPolyData* lines, const LineArrays& arrays)
  : Lines(lines)
  , Starts(1, 0)
  , FirstCell(lines->GetNumberOfVerts())
  , NumberOfPoints(lines->GetNumberOfPoints())
  , ConstantRadius(arrays.ConstantRadius)
{
  vtkCellArray* cells = lines->GetLines();
  this->Is64Bit = cells->IsStorage64Bit();
  this->Connectivity = cells->GetConnectivityArray()->GetVoidPointer(0);
  this->Starts.reserve(cells->GetNumberOfCells() + 1);
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    this->Starts.push_back(this->Starts.back() + std::max<long long>(cells->GetCellSize(cell) - 1, 0));
  }
  this->Offsets = cells->GetOffsetsArray()->GetVoidPointer(0);
  if (lines->GetPoints())
  {
    auto* points = vtkFloatArray::SafeDownCast(lines->GetPoints()->GetData());
    this->Floats = points ? points->GetPointer(0) : nullptr;
  }
  this->Radius = this->FindArray(arrays.Radius);
  this->Type = this->FindArray(arrays.Type);
  this->ReadColors(this->FindArray(arrays.Color), arrays);
}

LineInput::~LineInput() = default;

LineInput::Attribute LineInput::FindArray(const std::string& name)
{
  if (name.empty())
  {
    return {};
  }
  if (vtkDataArray* array = this->Lines->GetPointData()->GetArray(name.c_str()))
  {
    return { array, false };
  }
  vtkDataArray* array = this->Lines->GetCellData()->GetArray(name.c_str());
  if (!array && this->GetNumberOfSegments() > 0)
  {
    this->Missing += (this->Missing.empty() ? "\"" : ", \"") + name + "\"";
  }
  return { array, true }; // of cells, should it be missing
}

// Three or four components are a colour, of bytes or in [0, 1]; one goes through a table.
void LineInput::ReadColors(const Attribute& color, const LineArrays& arrays)
{
  if (!color.Array)
  {
    return;
  }
  vtkNew<vtkLookupTable> rainbow;
  rainbow->SetTableRange(color.Array->GetRange());
  vtkScalarsToColors* table = arrays.LookupTable ? arrays.LookupTable : rainbow.Get();
  const bool isColor = color.Array->GetNumberOfComponents() >= 3;
  this->Colors.TakeReference(table->MapScalars(
    color.Array, isColor ? VTK_COLOR_MODE_DIRECT_SCALARS : VTK_COLOR_MODE_MAP_SCALARS, 0, VTK_RGB));
  this->ColorsOfCells = color.OfCells;
}

LineInput::Cursor LineInput::Find(long long segment) const
{
  const auto after = std::upper_bound(this->Starts.begin(), this->Starts.end(), segment);
  return { (after - this->Starts.begin()) - 1 };
}

long long LineInput::IdAt(long long place) const
{
  return this->Is64Bit ? static_cast<const vtkTypeInt64*>(this->Connectivity)[place]
                       : static_cast<const vtkTypeInt32*>(this->Connectivity)[place];
}

glm::dvec3 LineInput::PointAt(long long point) const
{
  if (point < 0 || point >= this->NumberOfPoints)
  {
    return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  }
  if (this->Floats)
  {
    const float* numbers = this->Floats + 3 * point;
    return { numbers[0], numbers[1], numbers[2] };
  }
  glm::dvec3 position;
  this->Lines->GetPoints()->GetPoint(point, &position.x);
  return position;
}

glm::dvec3 LineInput::ColorAt(long long tuple) const
{
  const unsigned char* color = this->Colors->GetPointer(this->Colors->GetNumberOfComponents() * tuple);
  return glm::dvec3(color[0], color[1], color[2]) / 255.0;
}

LineSegment LineInput::Read(long long cell, long long inCell) const
{
  const long long offset = this->Is64Bit ? static_cast<const vtkTypeInt64*>(this->Offsets)[cell]
                                         : static_cast<const vtkTypeInt32*>(this->Offsets)[cell];
  const long long ends[2] = { this->IdAt(offset + inCell), this->IdAt(offset + inCell + 1) };
  const long long inCells = this->FirstCell + cell;
  LineSegment segment{ this->PointAt(ends[0]), this->PointAt(ends[1]), glm::dvec3(1.0), this->ConstantRadius,
    0 };
  const glm::dvec3 sum = segment.Begin + segment.End;
  if (!std::isfinite(sum.x + sum.y + sum.z))
  {
    return segment;
  }
  if (vtkDataArray* radii = this->Radius.Array)
  {
    segment.Radius = this->Radius.OfCells
      ? radii->GetComponent(inCells, 0)
      : 0.5 * (radii->GetComponent(ends[0], 0) + radii->GetComponent(ends[1], 0));
  }
  if (this->Type.Array)
  {
    const double type = this->Type.Array->GetComponent(this->Type.OfCells ? inCells : ends[0], 0);
    segment.Type = type >= 0.0 && type < 256.0 ? static_cast<int>(type) : -1;
  }
  if (this->Colors)
  {
    segment.Color =
      this->ColorsOfCells ? this->ColorAt(inCells) : 0.5 * (this->ColorAt(ends[0]) + this->ColorAt(ends[1]));
  }
  return segment;
}

std::set<int> LineInput::GetTypes() const
{
  if (!this->Type.Array)
  {
    return this->Type.OfCells ? std::set<int>() : std::set<int>{ 0 };
  }
  std::set<int> types;
  for (vtkIdType i = 0; i < this->Type.Array->GetNumberOfTuples(); ++i)
  {
    const double type = this->Type.Array->GetComponent(i, 0);
    if (type >= 0.0 && type < 256.0)
    {
      types.insert(static_cast<int>(type));
    }
  }
  return types;
}

LineBounds LineInput::GetBounds(long long first, long long last) const
{
  LineBounds bounds;
  this->ForEachSegment(first, last, [&](const LineSegment& segment) {
    const glm::dvec3 sum = segment.Begin + segment.End;
    if (std::isfinite(sum.x + sum.y + sum.z))
    {
      bounds.Add(segment.Begin);
      bounds.Add(segment.End);
    }
  });
  return bounds;
}
}
