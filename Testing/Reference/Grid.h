// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The grid of an image in dataset space, and trilinear interpolation on it in double.

#ifndef Grid_h
#define Grid_h

#include <glm/glm.hpp>

#include <array>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace reference
{
using Vector = glm::dvec3;

// A box of points along three orthogonal directions. Dataset space is what the volume's matrix takes
// to the world; lengths are measured there, as VTK's mapper does.
struct Grid
{
  Vector corner = Vector(-1.0); // the first point
  std::array<Vector, 3> directions = { Vector(1.0, 0.0, 0.0), Vector(0.0, 1.0, 0.0),
    Vector(0.0, 0.0, 1.0) };                         // unit
  std::array<double, 3> spacing = { 1.0, 1.0, 1.0 }; // 1 along an axis of one point
  std::array<int, 3> points = { 1, 1, 1 };

  Grid() = default;
  explicit Grid(vtkImageData* image);

  double Length(int axis) const { return this->spacing[axis] * (this->points[axis] - 1); }
  double SmallestSpacing() const;
  Vector Step(int axis) const { return this->directions[axis] * this->spacing[axis]; }

  // Continuous index from the first point.
  Vector ToIndex(const Vector& point) const;
};

// What part of a ray lies in the grid: parameters of origin + t direction; empty if entry > exit.
struct Interval
{
  double entry;
  double exit;
};
Interval Intersect(const Grid& grid, const Vector& origin, const Vector& direction);

// A point array of an image, interpolated as a linear GL texture does that is clamped to its edge.
class GridArray
{
public:
  GridArray(vtkImageData* image, vtkDataArray* array);

  const Grid& GetGrid() const { return this->Geometry; }
  int GetNumberOfComponents() const { return this->Components; }

  // One component at a point of dataset space.
  double Interpolate(const Vector& point, int component) const;
  // Three consecutive components.
  Vector InterpolateVector(const Vector& point, int firstComponent = 0) const;

private:
  struct Corners
  {
    std::array<size_t, 8> tuple;
    std::array<double, 8> weight;
  };
  Corners CornersOf(const Vector& point) const;

  Grid Geometry;
  int Components;
  std::vector<double> Values;
};
}

#endif
