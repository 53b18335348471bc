// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceExtent.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
const double Rounding = 1.0e-9; // as ImageGrid's

const Extent Nothing = { 0, -1, 0, -1, 0, -1 };
}

bool IsPiece(vtkInformation* output)
{
  return output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) &&
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
}

// Cells that are not ghosts fill a box: from the first to the last one.
Extent OwnExtent(vtkImageData* image)
{
  Extent points;
  image->GetExtent(points.data());
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  if (!ghosts || ghosts->GetNumberOfTuples() == 0)
  {
    return points;
  }
  const auto isOwn = [](unsigned char flags) { return (flags & vtkDataSetAttributes::DUPLICATECELL) == 0; };
  const unsigned char* begin = ghosts->GetPointer(0);
  const unsigned char* end = begin + ghosts->GetNumberOfTuples();
  const unsigned char* first = std::find_if(begin, end, isOwn);
  if (first == end)
  {
    return Nothing;
  }
  const unsigned char* last = end - 1;
  while (!isOwn(*last))
  {
    --last;
  }
  int low[3];
  int high[3];
  vtkStructuredData::ComputeCellStructuredCoordsForExtent(first - begin, points.data(), low);
  vtkStructuredData::ComputeCellStructuredCoordsForExtent(last - begin, points.data(), high);
  Extent own;
  for (int axis = 0; axis < 3; ++axis)
  {
    own[2 * axis] = low[axis];
    own[2 * axis + 1] = std::min(high[axis] + 1, points[2 * axis + 1]);
  }
  return own;
}

Extent OutputExtent(const ImageGrid& grid, const Extent& input)
{
  Extent output = Nothing;
  for (int axis = 0; axis < 3 && !IsEmpty(input); ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int index = 2 * axis + side;
      const int voxel = static_cast<int>(std::floor(input[index] * grid.Factor + Rounding));
      output[index] = std::clamp(voxel, grid.Whole[2 * axis], grid.Whole[2 * axis + 1]);
    }
  }
  return output;
}

int GhostLayersOfInput(const ImageGrid& grid, int layers, int reach)
{
  const int between = grid.Factor < 1.0 ? 1 : 0; // an output voxel that lies before the piece's first point
  return static_cast<int>(std::ceil((layers + reach + between) / grid.Factor - Rounding));
}

ImageGrid Restricted(const ImageGrid& grid, const Extent& input)
{
  ImageGrid restricted = grid;
  restricted.InputWhole = input;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = std::ceil(input[2 * axis] * grid.Factor - Rounding);
    const double last = std::floor(input[2 * axis + 1] * grid.Factor + Rounding);
    restricted.Whole[2 * axis] = std::max(grid.Whole[2 * axis], static_cast<int>(first));
    restricted.Whole[2 * axis + 1] = std::min(grid.Whole[2 * axis + 1], static_cast<int>(last));
  }
  return restricted;
}
}
