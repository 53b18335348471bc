// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SweepRegions.h"

#include "Optics.h"
#include "SweepGrid.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
// Around a point, that the interpolation between froxels reads.
const int Neighbors = 1;

// Of a place on the GPU, in froxels: what has no more weight than that is not read.
const double Rounding = 1.0e-5;

// Slices around a point that are interpolated between, whether they are taken for their front or for their middle.
const double SlicesAround = 2.0;

double FroxelSide(const SweepGrid& grid, int axis)
{
  return (grid.GetWindow()[2 * axis + 1] - grid.GetWindow()[2 * axis]) / grid.GetSize()[axis];
}

int Clamp(double froxel, int size)
{
  return static_cast<int>(std::clamp(froxel, 0.0, 1.0 * size));
}

SweepRectangle Whole(const SweepGrid& grid)
{
  return { { 0, 0 }, { grid.GetSize()[0], grid.GetSize()[1] } };
}

SweepRectangle Unite(const SweepRectangle& a, const SweepRectangle& b)
{
  if (a.IsEmpty() || b.IsEmpty())
  {
    return a.IsEmpty() ? b : a;
  }
  return { { std::min(a.Begin[0], b.Begin[0]), std::min(a.Begin[1], b.Begin[1]) },
    { std::max(a.End[0], b.End[0]), std::max(a.End[1], b.End[1]) } };
}

SweepRectangle Intersect(const SweepRectangle& a, const SweepRectangle& b)
{
  return { { std::max(a.Begin[0], b.Begin[0]), std::max(a.Begin[1], b.Begin[1]) },
    { std::min(a.End[0], b.End[0]), std::min(a.End[1], b.End[1]) } };
}

SweepRectangle Widen(const SweepRectangle& rectangle, const SweepGrid& grid, double aside)
{
  SweepRectangle wide;
  for (int axis = 0; axis < 2 && !rectangle.IsEmpty(); ++axis)
  {
    const double froxels = std::ceil(aside / FroxelSide(grid, axis)) + Neighbors;
    wide.Begin[axis] = Clamp(rectangle.Begin[axis] - froxels, grid.GetSize()[axis]);
    wide.End[axis] = Clamp(rectangle.End[axis] + froxels, grid.GetSize()[axis]);
  }
  return wide;
}

// Of the box, so far in front of the middle of a slice and behind it.
SweepRectangle PartOfBox(const SweepGrid& grid, const double corners[24], int slice, double along)
{
  const double depth = grid.GetDepth(slice);
  const double range[2] = { std::max(depth - along, grid.GetBegin()),
    std::min(depth + along, grid.GetEnd()) };
  double outline[4];
  SweepRectangle part;
  if (!grid.FindOutline(corners, range, outline))
  {
    return part;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const double* window = grid.GetWindow() + 2 * axis;
    const double side = FroxelSide(grid, axis);
    part.Begin[axis] = Clamp(std::floor((outline[2 * axis] - window[0]) / side), grid.GetSize()[axis]);
    part.End[axis] = Clamp(std::ceil((outline[2 * axis + 1] - window[0]) / side), grid.GetSize()[axis]);
  }
  return part;
}

// Who is in front of the grid looks at its first slices, who is behind it at its last ones.
bool IsSeenFromBeyond(const SweepGrid& grid, const double corners[24], int slice, double along)
{
  double depths[2];
  grid.FindDepths(corners, depths);
  const double depth = grid.GetDepth(slice);
  return (depths[0] < grid.GetBegin() && depth - along < grid.GetBegin()) ||
    (depths[1] > grid.GetEnd() && depth + along > grid.GetEnd());
}

// Of a cone about the line to the viewer, the slopes along one axis: between two planes that touch it. place: on that
// axis; other: the largest on the other one, which makes it appear wider.
void SlopesAboutEye(double angle, double place, double other, double slopes[2])
{
  const double steepest = 1.0 / optics::LeastRise;
  const double sine = std::sin(angle) * std::sqrt(1.0 + other * other / (1.0 + place * place));
  const double half = sine < 1.0 ? std::asin(sine) : vtkMath::Pi();
  const double right = vtkMath::Pi() / 2.0;
  const double least = -std::atan(place) - half, largest = -std::atan(place) + half;
  slopes[0] = least > -right ? std::max(std::tan(least), -steepest) : -steepest;
  slopes[1] = largest < right ? std::min(std::tan(largest), steepest) : steepest;
}

// How far a froxel reads what passed the slice before it, along one axis: its slopes relative to that of the line to the
// viewer, which goes through the same place on all slices.
class Reads
{
public:
  Reads(const SweepGrid& grid, const SweepCone& cone, int axis)
    : Grid(grid)
    , Axis(axis)
    , ViewerDistance(grid.GetIsPerspective() ? cone.ViewerDistance : 0.0)
  {
    const double* window = grid.GetWindow();
    const double other = std::max(std::abs(window[2 - 2 * axis]), std::abs(window[3 - 2 * axis]));
    for (int froxel = 0; froxel < grid.GetSize()[axis]; ++froxel)
    {
      this->AddFroxel(cone, window[2 * axis] + (froxel + 0.5) * FroxelSide(grid, axis), other);
    }
  }

  // What the froxels [begin, end) of the slice read.
  void FindRead(int slice, int& begin, int& end) const
  {
    const double scale = this->FroxelsPerSlope(slice);
    double first = begin, last = end;
    for (int i = begin; i < end; ++i)
    {
      first = std::min(first, this->FirstRead(i, scale));
      last = std::max(last, this->LastRead(i, scale) + 1.0);
    }
    this->Set(first, last, begin, end);
  }

  // Which of the slice's froxels read [begin, end).
  void FindReaders(int slice, int& begin, int& end) const
  {
    const double scale = this->FroxelsPerSlope(slice);
    double first = begin, last = end;
    for (int i = 0; i < static_cast<int>(this->Least.size()); ++i)
    {
      const bool reads = this->FirstRead(i, scale) < end && this->LastRead(i, scale) >= begin;
      first = reads ? std::min(first, 1.0 * i) : first;
      last = reads ? std::max(last, 1.0 + i) : last;
    }
    this->Set(first, last, begin, end);
  }

private:
  // Between froxels it is interpolated: those less than one away from a point have a weight. Beyond the window it is as
  // at its edge.
  double FirstRead(int froxel, double scale) const
  {
    return this->InWindow(std::ceil(froxel + scale * this->Least[froxel] - 1.0 + Rounding));
  }

  double LastRead(int froxel, double scale) const
  {
    return this->InWindow(std::floor(froxel + scale * this->Largest[froxel] + 1.0 - Rounding));
  }

  double InWindow(double froxel) const
  {
    return std::clamp(froxel, 0.0, this->Grid.GetSize()[this->Axis] - 1.0);
  }

  void AddFroxel(const SweepCone& cone, double place, double other)
  {
    const bool isPerspective = this->Grid.GetIsPerspective();
    const double tangent = std::tan(cone.Angle);
    double slopes[2] = { -tangent, tangent };
    if (isPerspective && cone.IsAboutEye)
    {
      SlopesAboutEye(cone.Angle, place, other, slopes);
    }
    const double toViewer = isPerspective && this->ViewerDistance <= 0.0 ? -place : 0.0;
    this->Least.push_back(slopes[0] - toViewer);
    this->Largest.push_back(slopes[1] - toViewer);
  }

  double FroxelsPerSlope(int slice) const
  {
    const double width = this->Grid.GetWidth(this->Grid.GetDepth(slice));
    const double before = this->Grid.GetWidth(this->Grid.GetDepth(std::max(slice - 1, 0)));
    const double places = this->Grid.GetSliceDistance() / before;
    return (this->ViewerDistance > 0.0 ? this->ViewerDistance / width : 1.0) * places /
      FroxelSide(this->Grid, this->Axis);
  }

  void Set(double first, double last, int& begin, int& end) const
  {
    begin = Clamp(first, this->Grid.GetSize()[this->Axis]);
    end = Clamp(last, this->Grid.GetSize()[this->Axis]);
  }

  const SweepGrid& Grid;
  int Axis;
  double ViewerDistance;
  std::vector<double> Least;
  std::vector<double> Largest;
};

class ReadsOfGrid
{
public:
  ReadsOfGrid(const SweepGrid& grid, const SweepCone& cone)
    : Axes{ Reads(grid, cone, 0), Reads(grid, cone, 1) }
  {
  }

  SweepRectangle FindRead(int slice, SweepRectangle region) const
  {
    for (int axis = 0; axis < 2 && !region.IsEmpty(); ++axis)
    {
      this->Axes[axis].FindRead(slice, region.Begin[axis], region.End[axis]);
    }
    return region;
  }

  SweepRectangle FindReaders(int slice, SweepRectangle region) const
  {
    for (int axis = 0; axis < 2 && !region.IsEmpty(); ++axis)
    {
      this->Axes[axis].FindReaders(slice, region.Begin[axis], region.End[axis]);
    }
    return region;
  }

private:
  Reads Axes[2];
};
}

//------------------------------------------------------------------------------
std::vector<SweepRectangle> WholeSweep(const SweepGrid& grid)
{
  return std::vector<SweepRectangle>(grid.GetSize()[2], Whole(grid));
}

//------------------------------------------------------------------------------
std::vector<SweepRectangle> FindSweepRegions(const SweepGrid& grid, const SweepContents& contents)
{
  const int slices = grid.GetSize()[2];
  std::vector<SweepRectangle> regions = WholeSweep(grid);
  const ReadsOfGrid reads(grid, contents.Cone);
  SweepRectangle hidden;
  for (int slice = 0; slice < slices && !contents.IsHiddenOutside; ++slice)
  {
    const SweepRectangle hiding = PartOfBox(grid, contents.Corners, slice, 0.5 * grid.GetSliceDistance());
    hidden = Unite(reads.FindReaders(slice, hidden), Widen(hiding, grid, 0.0));
    regions[slice] = hidden;
  }
  SweepRectangle seen;
  const double along = SlicesAround * grid.GetSliceDistance() + contents.LookAlong;
  for (int slice = slices - 1; slice >= 0; --slice)
  {
    const SweepRectangle looking = IsSeenFromBeyond(grid, contents.Corners, slice, along)
      ? Whole(grid)
      : PartOfBox(grid, contents.Corners, slice, along);
    seen = Unite(seen, Widen(looking, grid, contents.LookAside));
    regions[slice] = Intersect(regions[slice], seen);
    seen = reads.FindRead(slice, seen);
  }
  return regions;
}
