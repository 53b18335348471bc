// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Grid.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace reference
{
//------------------------------------------------------------------------------
Grid::Grid(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  double first[3];
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], first);
  this->corner = Vector(first[0], first[1], first[2]);
  const double* matrix = image->GetDirectionMatrix()->GetData();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->directions[axis] = Vector(matrix[axis], matrix[3 + axis], matrix[6 + axis]);
    this->spacing[axis] = std::abs(image->GetSpacing()[axis]);
    this->points[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
}

//------------------------------------------------------------------------------
double Grid::SmallestSpacing() const
{
  return *std::min_element(this->spacing.begin(), this->spacing.end());
}

//------------------------------------------------------------------------------
Vector Grid::ToIndex(const Vector& point) const
{
  const Vector offset = point - this->corner;
  return Vector(glm::dot(offset, this->directions[0]) / this->spacing[0],
    glm::dot(offset, this->directions[1]) / this->spacing[1],
    glm::dot(offset, this->directions[2]) / this->spacing[2]);
}

//------------------------------------------------------------------------------
Interval Intersect(const Grid& grid, const Vector& origin, const Vector& direction)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Interval inside = { -infinity, infinity };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double start = glm::dot(origin - grid.corner, grid.directions[axis]);
    const double slope = glm::dot(direction, grid.directions[axis]);
    const double length = grid.Length(axis);
    if (slope == 0.0)
    {
      if (start < 0.0 || start > length)
      {
        return { 1.0, 0.0 };
      }
      continue;
    }
    const double first = -start / slope;
    const double second = (length - start) / slope;
    inside.entry = std::max(inside.entry, std::min(first, second));
    inside.exit = std::min(inside.exit, std::max(first, second));
  }
  return inside;
}

//------------------------------------------------------------------------------
GridArray::GridArray(vtkImageData* image, vtkDataArray* array)
  : Geometry(image)
{
  if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::invalid_argument("The reference needs an array with one tuple for each point of the image.");
  }
  this->Components = array->GetNumberOfComponents();
  this->Values.resize(static_cast<size_t>(array->GetNumberOfTuples()) * this->Components);
  for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
  {
    array->GetTuple(tuple, &this->Values[static_cast<size_t>(tuple) * this->Components]);
  }
}

//------------------------------------------------------------------------------
GridArray::Corners GridArray::CornersOf(const Vector& point) const
{
  const Vector index = this->Geometry.ToIndex(point);
  std::array<size_t, 3> cell;
  std::array<size_t, 3> next;
  std::array<double, 3> weight;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = this->Geometry.points[axis] - 1;
    const double clamped = std::clamp(index[axis], 0.0, static_cast<double>(last));
    const int low = std::min(static_cast<int>(clamped), last);
    cell[axis] = static_cast<size_t>(low);
    next[axis] = static_cast<size_t>(std::min(low + 1, last));
    weight[axis] = clamped - low;
  }
  const size_t row = static_cast<size_t>(this->Geometry.points[0]);
  const size_t slice = row * static_cast<size_t>(this->Geometry.points[1]);
  Corners corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    const bool x = (corner & 1) != 0;
    const bool y = (corner & 2) != 0;
    const bool z = (corner & 4) != 0;
    corners.tuple[corner] =
      (x ? next[0] : cell[0]) + row * (y ? next[1] : cell[1]) + slice * (z ? next[2] : cell[2]);
    corners.weight[corner] = (x ? weight[0] : 1.0 - weight[0]) * (y ? weight[1] : 1.0 - weight[1]) *
      (z ? weight[2] : 1.0 - weight[2]);
  }
  return corners;
}

//------------------------------------------------------------------------------
double GridArray::Interpolate(const Vector& point, int component) const
{
  const Corners corners = this->CornersOf(point);
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    sum += corners.weight[i] * this->Values[corners.tuple[i] * this->Components + component];
  }
  return sum;
}

//------------------------------------------------------------------------------
Vector GridArray::InterpolateVector(const Vector& point, int firstComponent) const
{
  const Corners corners = this->CornersOf(point);
  Vector sum(0.0);
  for (int i = 0; i < 8; ++i)
  {
    const double* tuple = &this->Values[corners.tuple[i] * this->Components + firstComponent];
    sum += corners.weight[i] * Vector(tuple[0], tuple[1], tuple[2]);
  }
  return sum;
}
}
