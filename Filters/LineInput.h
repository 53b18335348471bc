// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The segments of a vtkPolyData's lines, with radius, type and colour, by number. Reads from any thread.

#ifndef LineInput_h
#define LineInput_h

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <set>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkScalarsToColors;
class vtkUnsignedCharArray;

namespace volumeoptics
{
struct LineSegment
{
  glm::dvec3 Begin, End;
  glm::dvec3 Color;
  double Radius;
  int Type;
};

struct LineArrays
{
  std::string Radius, Type, Color; // empty: none
  double ConstantRadius = 1.0;
  vtkScalarsToColors* LookupTable = nullptr;
};

// Of a whole input.
struct LineBounds
{
  glm::dvec3 Least = glm::dvec3(1e300), Largest = glm::dvec3(-1e300);
  bool IsEmpty() const { return this->Least.x > this->Largest.x; }
  void Add(const glm::dvec3& point)
  {
    this->Least = glm::min(this->Least, point);
    this->Largest = glm::max(this->Largest, point);
  }
  void Add(const LineBounds& other)
  {
    this->Least = glm::min(this->Least, other.Least);
    this->Largest = glm::max(this->Largest, other.Largest);
  }
};

class LineInput
{
public:
  LineInput(vtkPolyData* lines, const LineArrays& arrays);
  ~LineInput();

  // Names of arrays that were asked for and are not there; empty: none.
  const std::string& GetMissing() const { return this->Missing; }
  long long GetNumberOfSegments() const { return this->Starts.back(); }
  // Calls visit(segment) for the segments from first to last; points that are not finite, radii that are
  // no number and types outside of [0, 255] are for the visitor to see.
  template <class Visit>
  void ForEachSegment(long long first, long long last, const Visit& visit) const
  {
    for (Cursor cursor = this->Find(first); first < last; ++first)
    {
      while (first >= this->Starts[cursor.Cell + 1])
      {
        ++cursor.Cell;
      }
      visit(this->Read(cursor.Cell, first - this->Starts[cursor.Cell]));
    }
  }
  // Types in [0, 255] that occur; none where their array is missing.
  std::set<int> GetTypes() const;
  // Of the finite points of the segments from first to last.
  LineBounds GetBounds(long long first, long long last) const;

private:
  struct Cursor
  {
    long long Cell;
  };
  struct Attribute
  {
    vtkDataArray* Array = nullptr;
    bool OfCells = false;
  };

  Attribute FindArray(const std::string& name);
  void ReadColors(const Attribute& color, const LineArrays& arrays);
  Cursor Find(long long segment) const;
  LineSegment Read(long long cell, long long inCell) const;
  glm::dvec3 PointAt(long long point) const;
  glm::dvec3 ColorAt(long long tuple) const;
  long long IdAt(long long place) const;

  vtkPolyData* Lines;
  std::vector<long long> Starts; // of each cell's segments
  const void* Connectivity = nullptr;
  const void* Offsets = nullptr;
  bool Is64Bit = true;
  long long FirstCell = 0; // of the lines among the cells
  long long NumberOfPoints = 0;
  const float* Floats = nullptr; // the points, where they are of this type
  Attribute Radius, Type;
  bool ColorsOfCells = false;
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  double ConstantRadius;
  std::string Missing;
};
}

#endif
