// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a sweep leaves out, ray by ray: no froxel in which light may be missing is left out of what is hidden, and none
// that is read is left out of what is looked at. Grids, boxes and cones at random.

#include "Check.h"
#include "Dice.h"
#include "Optics.h"
#include "SweepGrid.h"
#include "SweepRegions.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
const int Directions = 16;
const double Weight = 1.0e-4; // of a froxel that is read

void SetBox(const double center[3], double side, double corners[24])
{
  for (int i = 0; i < 24; ++i)
  {
    const int corner = i / 3, axis = i % 3;
    corners[i] = center[axis] + side * (((corner >> axis) & 1) - 0.5);
  }
}

// Looking along z, at the box or near it.
SweepGrid MakeGrid(Dice& dice)
{
  SweepGrid::View view = {};
  for (const int i : { 0, 5, 10, 15 })
  {
    view.WorldToView[i] = 1.0;
  }
  view.IsPerspective = dice.Is(0.7);
  view.Range[0] = view.IsPerspective ? 0.05 : -5.0;
  view.Range[1] = 100.0;
  const double half = view.IsPerspective ? dice.Between(0.1, 1.5) : dice.Between(0.5, 3.0);
  for (int side = 0; side < 4; ++side)
  {
    view.Window[side] = side % 2 == 0 ? -half : half;
  }
  const double center[3] = { dice.Between(-0.5, 0.5), dice.Between(-0.5, 0.5), dice.Between(1.2, 6.0) };
  double corners[24];
  SetBox(center, 2.0, corners);
  return SweepGrid(view, corners, { 3 + dice.Number(30), dice.Between(0.3, 3.0), 512 });
}

SweepContents MakeContents(Dice& dice)
{
  SweepContents contents = {};
  const double center[3] = { dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), dice.Between(1.0, 6.0) };
  SetBox(center, dice.Between(0.1, 1.0), contents.Corners);
  contents.Cone.Angle = vtkMath::RadiansFromDegrees(dice.Is(0.1) ? 0.0
      : dice.Is(0.5)                                             ? dice.Between(0.1, 80.0)
                                                                 : dice.PowerOfTen(-1.0, 1.5));
  contents.Cone.IsAboutEye = dice.Is(0.5);
  contents.Cone.ViewerDistance = !contents.Cone.IsAboutEye && dice.Is(0.5) ? dice.Between(0.1, 6.0) : 0.0;
  return contents;
}

// As the shader has it (SweepDirections.glsl).
glm::dvec2 SlopeOf(const SweepGrid& grid, const SweepCone& cone, int slice, int direction, glm::dvec2 place)
{
  const glm::dvec2 slope = optics::ConeDirection(direction, Directions, std::cos(cone.Angle)).slope;
  if (grid.GetIsPerspective() && cone.IsAboutEye)
  {
    const glm::dvec3 axis = -glm::normalize(glm::dvec3(place, 1.0));
    return optics::SlopeOfWay(optics::TurnToAxis(glm::dvec3(slope, -1.0), axis));
  }
  if (grid.GetIsPerspective() && cone.ViewerDistance > 0.0)
  {
    return slope * (cone.ViewerDistance / grid.GetWidth(grid.GetDepth(slice))) - place;
  }
  return slope;
}

bool Holds(const SweepRectangle& region, int x, int y)
{
  return x >= region.Begin[0] && x < region.End[0] && y >= region.Begin[1] && y < region.End[1];
}

// Whether a froxel reads one of the region, on the slice before it.
bool Reads(const SweepGrid& grid, const SweepCone& cone, int slice, int x, int y, bool ofRegion,
  const SweepRectangle& region)
{
  const double* window = grid.GetWindow();
  const int* size = grid.GetSize();
  const glm::dvec2 side((window[1] - window[0]) / size[0], (window[3] - window[2]) / size[1]);
  const glm::dvec2 first(window[0], window[2]);
  const glm::dvec2 place = first + side * (glm::dvec2(x, y) + 0.5);
  const double width = grid.GetWidth(grid.GetDepth(slice)), before = grid.GetWidth(grid.GetDepth(slice - 1));
  bool reads = false;
  for (int i = 0; i < Directions; ++i)
  {
    const glm::dvec2 slope = SlopeOf(grid, cone, slice, i, place);
    const glm::dvec2 there = optics::PlaceOnSlice(place, slope, grid.GetSliceDistance(), width, before);
    const glm::dvec2 froxel = (there - first) / side - 0.5;
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::dvec2 texel = glm::floor(froxel) + glm::dvec2(corner & 1, corner >> 1);
      const glm::dvec2 weight = 1.0 - glm::abs(texel - froxel);
      const int column = static_cast<int>(std::clamp(texel.x, 0.0, size[0] - 1.0));
      const int row = static_cast<int>(std::clamp(texel.y, 0.0, size[1] - 1.0));
      reads |= std::min(weight.x, weight.y) > Weight && Holds(region, column, row) == ofRegion;
    }
  }
  return reads;
}

// Froxels of all slices for which reading is wrong.
int CountFaults(const SweepGrid& grid, const SweepContents& contents, bool areHidden)
{
  const std::vector<SweepRectangle> regions = FindSweepRegions(grid, contents);
  int faults = 0;
  for (int slice = 1; slice < grid.GetSize()[2]; ++slice)
  {
    for (int froxel = 0; froxel < grid.GetSize()[0] * grid.GetSize()[1]; ++froxel)
    {
      const int x = froxel % grid.GetSize()[0], y = froxel / grid.GetSize()[0];
      const bool isIn = Holds(regions[slice], x, y);
      const bool isAsked = areHidden ? !isIn : isIn;
      faults += isAsked && Reads(grid, contents.Cone, slice, x, y, areHidden, regions[slice - 1]) ? 1 : 0;
    }
  }
  return faults;
}

// Where everything is looked at, what is left out has all light: it reads nothing that may be hidden.
int CountHiddenFaults(const SweepGrid& grid, SweepContents contents)
{
  contents.LookAlong = contents.LookAside = 1.0e6;
  return CountFaults(grid, contents, true);
}

// Where everything may be hidden, what is drawn reads nothing that is left out.
int CountSeenFaults(const SweepGrid& grid, SweepContents contents)
{
  contents.IsHiddenOutside = true;
  return CountFaults(grid, contents, false);
}
}

int TestSweepReads(int, char*[])
{
  Check check;
  double leftOut = 0.0;
  const int grids = 400;
  for (int seed = 1; seed <= grids; ++seed)
  {
    Dice dice(seed);
    const SweepGrid grid = MakeGrid(dice);
    const SweepContents contents = MakeContents(dice);
    if (grid.IsEmpty())
    {
      continue;
    }
    const std::string name = "grid " + std::to_string(seed);
    check.Near(name + ": froxels that are hidden after all", CountHiddenFaults(grid, contents), 0.0, 0.0);
    check.Near(name + ": froxels that are read after all", CountSeenFaults(grid, contents), 0.0, 0.0);
    const std::vector<SweepRectangle> regions = FindSweepRegions(grid, contents);
    leftOut += std::count_if(regions.begin(), regions.end(), [](const auto& r) { return r.IsEmpty(); }) > 0;
  }
  check.AtLeast("grids of which slices are left out", leftOut, 0.3 * grids);
  return check.ExitCode();
}
