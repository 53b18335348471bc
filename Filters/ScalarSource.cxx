// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ScalarSource.h"

#include "GaussianFilter.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
template <typename Value>
void ReadMemory(const Value* memory, int stride, int count, double* values)
{
  for (int i = 0; i < count; ++i)
  {
    values[i] = static_cast<double>(memory[static_cast<std::ptrdiff_t>(i) * stride]);
  }
}

// Position between two voxels along one axis.
struct Position
{
  int Voxel;
  int Next;
  double Weight; // of Next
};

Position PositionAlong(const ImageGrid& grid, int axis, int index)
{
  const int least = grid.InputWhole[2 * axis];
  const int largest = grid.InputWhole[2 * axis + 1];
  const double exact = std::clamp(index / grid.Factor, double(least), double(largest));
  const double nearest = std::round(exact);
  if (std::abs(exact - nearest) < 1.0e-9)
  {
    return { static_cast<int>(nearest), static_cast<int>(nearest), 0.0 };
  }
  const int voxel = static_cast<int>(std::floor(exact));
  return { voxel, voxel + 1, exact - voxel };
}

// A weight of 0 must not let a missing value in.
double Between(double value, double next, double weight)
{
  return weight == 0.0 ? value : value + weight * (next - value);
}
}

ImageRows::ImageRows(vtkImageData* image, vtkDataArray* array, int component)
  : Array(array)
  , Ghosts(image->GetPointGhostArray())
  , Component(component)
  , Memory(array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT ? array->GetVoidPointer(0)
                                                                               : nullptr)
{
  image->GetExtent(this->Box.data());
}

void ImageRows::Read(int x0, int x1, int y, int z, double* values) const
{
  const vtkIdType nx = this->Box[1] - this->Box[0] + 1;
  const vtkIdType ny = this->Box[3] - this->Box[2] + 1;
  const vtkIdType point = (x0 - this->Box[0]) + nx * ((y - this->Box[2]) + ny * (z - this->Box[4]));
  const int count = x1 - x0 + 1;
  const int stride = this->Array->GetNumberOfComponents();
  const vtkIdType start = point * stride + this->Component;
  switch (this->Memory ? this->Array->GetDataType() : VTK_VOID)
  {
    vtkTemplateMacro(ReadMemory(static_cast<const VTK_TT*>(this->Memory) + start, stride, count, values));
    default:
      for (int i = 0; i < count; ++i)
      {
        values[i] = this->Array->GetComponent(point + i, this->Component);
      }
  }
  std::transform(values, values + count, values,
    [](double value) { return std::isfinite(value) ? value : NoValue<double>(); });
  const unsigned char* ghosts = this->Ghosts ? this->Ghosts->GetPointer(point) : nullptr;
  for (int i = 0; ghosts && i < count; ++i)
  {
    values[i] = ghosts[i] & vtkDataSetAttributes::HIDDENPOINT ? NoValue<double>() : values[i];
  }
}

ScalarSource::ScalarSource(const ImageGrid& grid, const ImageRows& rows, double smoothing)
  : Grid(grid)
  , Rows(rows)
  , Smoothing(smoothing)
{
}

void ScalarSource::ReadResampledRow(int x0, int x1, int y, int z, double* values) const
{
  const Extent input = InputExtent(this->Grid, { x0, x1, y, y, z, z });
  const std::size_t length = input[1] - input[0] + 1;
  std::vector<double> rows(4 * length);
  const Position atY = PositionAlong(this->Grid, 1, y);
  const Position atZ = PositionAlong(this->Grid, 2, z);
  for (int row = 0; row < 4; ++row)
  {
    this->Rows.Read(input[0], input[1], row % 2 ? atY.Next : atY.Voxel, row / 2 ? atZ.Next : atZ.Voxel,
      rows.data() + row * length);
  }
  for (std::size_t i = 0; i < length; ++i)
  {
    const double near = Between(rows[i], rows[i + length], atY.Weight);
    const double far = Between(rows[i + 2 * length], rows[i + 3 * length], atY.Weight);
    rows[i] = Between(near, far, atZ.Weight);
  }
  for (int x = x0; x <= x1; ++x)
  {
    const Position atX = PositionAlong(this->Grid, 0, x);
    values[x - x0] = Between(rows[atX.Voxel - input[0]], rows[atX.Next - input[0]], atX.Weight);
  }
}

VoxelBox<double> ScalarSource::LoadUnsmoothed(const Extent& box) const
{
  VoxelBox<double> scalars(box, 1, 1, NoValue<double>());
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      if (this->Grid.Factor == 1.0)
      {
        this->Rows.Read(box[0], box[1], y, z, scalars.Row(y, z));
      }
      else
      {
        this->ReadResampledRow(box[0], box[1], y, z, scalars.Row(y, z));
      }
    }
  }
  return scalars;
}

VoxelBox<double> ScalarSource::Load(const Extent& box) const
{
  if (this->Smoothing <= 0.0)
  {
    return this->LoadUnsmoothed(box);
  }
  const GaussianFilter gaussian(this->Grid, this->Smoothing);
  const Extent around = Grown(box, gaussian.GetHalo(), this->Grid.Whole);
  return gaussian.Apply(this->LoadUnsmoothed(around), box);
}
}
