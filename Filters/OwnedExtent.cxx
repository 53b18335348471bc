// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnedExtent.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
// Of the elements of a box that are not marked.
Extent ExtentWithout(const unsigned char* marks, unsigned char mark, const Extent& box)
{
  Extent extent = { box[1] + 1, box[0] - 1, box[3] + 1, box[2] - 1, box[5] + 1, box[4] - 1 };
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      for (int x = box[0]; x <= box[1]; ++x)
      {
        if (!(*marks++ & mark))
        {
          extent = { std::min(extent[0], x), std::max(extent[1], x), std::min(extent[2], y),
            std::max(extent[3], y), std::min(extent[4], z), std::max(extent[5], z) };
        }
      }
    }
  }
  return extent;
}
}

Extent OwnedExtent(vtkImageData* image)
{
  Extent points;
  image->GetExtent(points.data());
  if (IsEmpty(points))
  {
    return points;
  }
  if (vtkUnsignedCharArray* ghosts = image->GetCellGhostArray())
  {
    Extent cells = points;
    for (int axis = 0; axis < 3; ++axis)
    {
      cells[2 * axis + 1] = std::max(points[2 * axis], points[2 * axis + 1] - 1);
    }
    Extent owned = ExtentWithout(ghosts->GetPointer(0), vtkDataSetAttributes::DUPLICATECELL, cells);
    for (int axis = 0; axis < 3 && !IsEmpty(owned); ++axis)
    {
      owned[2 * axis + 1] += points[2 * axis] < points[2 * axis + 1];
    }
    return owned;
  }
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  return ghosts ? ExtentWithout(ghosts->GetPointer(0), vtkDataSetAttributes::DUPLICATEPOINT, points) : points;
}
}
