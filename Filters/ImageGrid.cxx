// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageGrid.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// Lengths below a billionth of a voxel are rounding errors of index / factor.
const double Rounding = 1.0e-9;

double ValidSpacing(double spacing)
{
  return spacing != 0.0 && std::isfinite(spacing) ? spacing : 1.0;
}

void FillDirection(vtkInformation* input, ImageGrid& grid)
{
  grid.Direction = glm::dmat3(1.0);
  if (input->Has(vtkDataObject::DIRECTION()))
  {
    const double* rows = input->Get(vtkDataObject::DIRECTION());
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        grid.Direction[column][row] = rows[3 * row + column];
      }
    }
  }
  const bool isRegular = std::abs(glm::determinant(grid.Direction)) > 0.0;
  grid.GradientToWorld = isRegular ? glm::inverse(glm::transpose(grid.Direction)) : glm::dmat3(1.0);
}

double FinestSpacing(const ImageGrid& grid)
{
  double finest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = std::abs(grid.Spacing[axis]);
    if (grid.InputWhole[2 * axis] < grid.InputWhole[2 * axis + 1])
    {
      finest = finest > 0.0 ? std::min(finest, length) : length;
    }
  }
  return finest > 0.0 ? finest : 1.0;
}

void FillWhole(ImageGrid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = grid.InputWhole[2 * axis];
    const int last = grid.InputWhole[2 * axis + 1];
    grid.Whole[2 * axis] = static_cast<int>(std::ceil(first * grid.Factor - Rounding));
    grid.Whole[2 * axis + 1] = last < first
      ? grid.Whole[2 * axis] - 1
      : std::max(grid.Whole[2 * axis], static_cast<int>(std::floor(last * grid.Factor + Rounding)));
  }
}

int FloorMultiple(int value, int size)
{
  const int quotient = value / size - (value % size < 0 ? 1 : 0);
  return quotient * size;
}
}

ImageGrid MakeImageGrid(vtkInformation* input, double factor)
{
  ImageGrid grid;
  grid.Factor = factor;
  input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), grid.InputWhole.data());
  const double* spacing =
    input->Has(vtkDataObject::SPACING()) ? input->Get(vtkDataObject::SPACING()) : nullptr;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Spacing[axis] = ValidSpacing(spacing ? spacing[axis] : 1.0);
  }
  FillWhole(grid);
  FillDirection(input, grid);
  grid.VoxelLength = FinestSpacing(grid);
  grid.Spacing /= factor;
  return grid;
}

Extent InputExtent(const ImageGrid& grid, const Extent& output)
{
  Extent extent;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int least = grid.InputWhole[2 * axis];
    const int largest = grid.InputWhole[2 * axis + 1];
    const double first = output[2 * axis] / grid.Factor + Rounding;
    const double last = output[2 * axis + 1] / grid.Factor - Rounding;
    extent[2 * axis] = std::clamp(static_cast<int>(std::floor(first)), least, largest);
    extent[2 * axis + 1] = std::clamp(static_cast<int>(std::ceil(last)), least, largest);
  }
  return extent;
}

Extent OutputExtent(const ImageGrid& grid, const Extent& input)
{
  Extent extent;
  for (int i = 0; i < 6; ++i)
  {
    extent[i] = static_cast<int>(std::ceil(input[i] * grid.Factor - Rounding));
  }
  return Intersection(extent, grid.Whole);
}

ImageGrid ClippedGrid(const ImageGrid& grid, const Extent& input)
{
  ImageGrid clipped = grid;
  clipped.InputWhole = Intersection(grid.InputWhole, input);
  FillWhole(clipped);
  clipped.Whole = Intersection(grid.Whole, clipped.Whole);
  return clipped;
}

Halo CoveringHalo(const ImageGrid& grid, double length)
{
  Halo halo;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = grid.Whole[2 * axis + 1] - grid.Whole[2 * axis];
    const double voxels = std::ceil(length / std::abs(grid.Spacing[axis]) - Rounding);
    halo[axis] = static_cast<int>(std::clamp(voxels, 0.0, static_cast<double>(std::max(last, 0))));
  }
  return halo;
}

Extent Grown(const Extent& extent, const Halo& halo, const Extent& whole)
{
  Extent grown;
  for (int axis = 0; axis < 3; ++axis)
  {
    grown[2 * axis] = std::max(extent[2 * axis] - halo[axis], whole[2 * axis]);
    grown[2 * axis + 1] = std::min(extent[2 * axis + 1] + halo[axis], whole[2 * axis + 1]);
  }
  return grown;
}

Extent Intersection(const Extent& a, const Extent& b)
{
  Extent common;
  for (int axis = 0; axis < 3; ++axis)
  {
    common[2 * axis] = std::max(a[2 * axis], b[2 * axis]);
    common[2 * axis + 1] = std::min(a[2 * axis + 1], b[2 * axis + 1]);
  }
  return common;
}

bool IsEmpty(const Extent& extent)
{
  return extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4];
}

bool Contains(const Extent& outer, const Extent& inner)
{
  bool contains = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    contains = contains && outer[2 * axis] <= inner[2 * axis] && outer[2 * axis + 1] >= inner[2 * axis + 1];
  }
  return contains;
}

long long NumberOfVoxels(const Extent& extent)
{
  return IsEmpty(extent)
    ? 0
    : (extent[1] - extent[0] + 1LL) * (extent[3] - extent[2] + 1LL) * (extent[5] - extent[4] + 1LL);
}

std::vector<Extent> SplitIntoTiles(const Extent& extent, int sizeY, int sizeZ)
{
  std::vector<Extent> tiles;
  for (int z = FloorMultiple(extent[4], sizeZ); z <= extent[5]; z += sizeZ)
  {
    for (int y = FloorMultiple(extent[2], sizeY); y <= extent[3]; y += sizeY)
    {
      tiles.push_back({ extent[0], extent[1], std::max(y, extent[2]), std::min(y + sizeY - 1, extent[3]),
        std::max(z, extent[4]), std::min(z + sizeZ - 1, extent[5]) });
    }
  }
  return tiles;
}

std::vector<Extent> SplitIntoTiles(const Extent& extent, int largest, double voxels)
{
  const std::size_t enough = 48;
  const double length = extent[1] - extent[0] + 1.0;
  int sizeY = largest;
  int sizeZ = largest;
  std::vector<Extent> tiles = SplitIntoTiles(extent, sizeY, sizeZ);
  while (sizeY > 1 && (tiles.size() < enough || length * sizeY * sizeZ > voxels))
  {
    (sizeZ > 1 && sizeZ >= sizeY ? sizeZ : sizeY) /= 2;
    tiles = SplitIntoTiles(extent, sizeY, sizeZ);
  }
  return tiles;
}
}
