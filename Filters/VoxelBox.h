// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Rows of voxels of an extent, one or more numbers a voxel, with room at both ends of each row.

#ifndef VoxelBox_h
#define VoxelBox_h

#include "ImageGrid.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>

namespace volumeoptics
{
// "No value here": blanked, outside, NaN or infinite.
template <typename Number>
constexpr Number NoValue()
{
  return std::numeric_limits<Number>::quiet_NaN();
}

template <typename Number>
class VoxelBox
{
public:
  VoxelBox() = default;

  // padding: numbers before the first and after the last voxel of a row. Nothing is set yet: large
  // boxes are set by the threads that work on them.
  VoxelBox(const Extent& box, int components, int padding)
    : Box(box)
    , Components(components)
    , Padding(padding)
    , RowLength(static_cast<std::size_t>(box[1] - box[0] + 1) * components + 2 * padding)
    , Size(RowLength * (box[3] - box[2] + 1) * (box[5] - box[4] + 1))
    , Numbers(new Number[Size])
  {
  }

  VoxelBox(const Extent& box, int components, int padding, Number value)
    : VoxelBox(box, components, padding)
  {
    std::fill(this->Numbers.get(), this->Numbers.get() + this->Size, value);
  }

  // A row with its padding.
  void SetRow(int y, int z, Number value)
  {
    Number* start = this->Row(y, z) - this->Padding;
    std::fill(start, start + this->RowLength, value);
  }

  const Extent& GetBox() const { return this->Box; }
  int GetComponents() const { return this->Components; }
  bool HasRow(int y, int z) const
  {
    return y >= this->Box[2] && y <= this->Box[3] && z >= this->Box[4] && z <= this->Box[5];
  }

  // The first voxel of a row: x = GetBox()[0].
  Number* Row(int y, int z) { return this->Numbers.get() + this->RowStart(y, z); }
  const Number* Row(int y, int z) const { return this->Numbers.get() + this->RowStart(y, z); }

  // Numbers from a voxel to the one at an index offset.
  std::ptrdiff_t Offset(int dx, int dy, int dz) const
  {
    const std::ptrdiff_t rowsPerSlice = this->Box[3] - this->Box[2] + 1;
    return static_cast<std::ptrdiff_t>(dx) * this->Components +
      static_cast<std::ptrdiff_t>(this->RowLength) * (dy + rowsPerSlice * dz);
  }

  Number* At(int x, int y, int z)
  {
    return this->Row(y, z) + static_cast<std::ptrdiff_t>(x - this->Box[0]) * this->Components;
  }
  const Number* At(int x, int y, int z) const
  {
    return this->Row(y, z) + static_cast<std::ptrdiff_t>(x - this->Box[0]) * this->Components;
  }

private:
  std::size_t RowStart(int y, int z) const
  {
    const std::size_t rowsPerSlice = this->Box[3] - this->Box[2] + 1;
    return this->Padding + this->RowLength * ((y - this->Box[2]) + rowsPerSlice * (z - this->Box[4]));
  }

  Extent Box = { 0, -1, 0, -1, 0, -1 };
  int Components = 1;
  std::size_t Padding = 0;
  std::size_t RowLength = 0;
  std::size_t Size = 0;
  std::unique_ptr<Number[]> Numbers;
};
}

#endif
