// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Ranges of the scalars in one layer of macrocells, each with one voxel more on each side. A voxel's row is
// reduced along x once, and then joins the rows of cells that it belongs to.

#ifndef MacrocellRanges_h
#define MacrocellRanges_h

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace volumeoptics
{
// Ranges of cells, side by side; a scalar that is not finite counts as none, and is told.
struct MacrocellRow
{
  explicit MacrocellRow(std::size_t size)
    : Lowest(size, std::numeric_limits<float>::infinity())
    , Highest(size, -std::numeric_limits<float>::infinity())
    , NonFinite(size, 0)
  {
  }
  std::vector<float> Lowest, Highest;
  std::vector<unsigned char> NonFinite;
};

// Which voxels a cell has, with one more on each side, and which cells a voxel.
struct MacrocellLattice
{
  MacrocellLattice(const int dimensions[3], int cellSize)
    : CellSize(cellSize)
  {
    std::copy(dimensions, dimensions + 3, this->Dimensions);
  }

  int CellsOn(int axis) const { return (this->Dimensions[axis] + this->CellSize - 1) / this->CellSize; }
  int FirstVoxel(int cell) const { return std::max(cell * this->CellSize - 1, 0); }
  int EndVoxel(int cell, int axis) const
  {
    return std::min((cell + 1) * this->CellSize + 1, this->Dimensions[axis]);
  }
  int FirstCell(int voxel) const { return std::max(voxel - 1, 0) / this->CellSize; }
  int LastCell(int voxel, int axis) const
  {
    return std::min((voxel + 1) / this->CellSize, this->CellsOn(axis) - 1);
  }

  int Dimensions[3];
  int CellSize;
};

template <typename Scalar>
class MacrocellLayer
{
public:
  // scalars: the component of the first voxel; stride: components.
  MacrocellLayer(const Scalar* scalars, int stride, const MacrocellLattice& lattice)
    : Scalars(scalars)
    , Stride(stride)
    , Lattice(lattice)
    , Columns(lattice.CellsOn(0))
  {
  }

  MacrocellRow Find(int layer) const
  {
    MacrocellRow cells(static_cast<std::size_t>(this->Columns) * this->Lattice.CellsOn(1));
    for (int z = this->Lattice.FirstVoxel(layer); z < this->Lattice.EndVoxel(layer, 2); ++z)
    {
      for (int y = 0; y < this->Lattice.Dimensions[1]; ++y)
      {
        this->Join(y, this->Reduce(y, z), cells);
      }
    }
    return cells;
  }

private:
  // The cells of a row of voxels.
  MacrocellRow Reduce(int y, int z) const
  {
    MacrocellRow row(this->Columns);
    const int* size = this->Lattice.Dimensions;
    const std::size_t voxel = (static_cast<std::size_t>(z) * size[1] + y) * size[0];
    const Scalar* first = this->Scalars + voxel * this->Stride;
    for (int column = 0; column < this->Columns; ++column)
    {
      const int begin = this->Lattice.FirstVoxel(column), end = this->Lattice.EndVoxel(column, 0);
      this->ReduceCell(first + static_cast<std::size_t>(begin) * this->Stride, end - begin, column, row);
    }
    return row;
  }

  void ReduceCell(const Scalar* scalar, int count, int column, MacrocellRow& row) const
  {
    Scalar lowest = std::numeric_limits<Scalar>::max();
    Scalar highest = std::numeric_limits<Scalar>::lowest();
    bool isFinite = true;
    for (int i = 0; i < count; ++i, scalar += this->Stride)
    {
      lowest = *scalar < lowest ? *scalar : lowest;
      highest = *scalar > highest ? *scalar : highest;
      isFinite &= IsFinite(*scalar);
    }
    row.NonFinite[column] = isFinite ? 0 : 1;
    if (lowest <= highest)
    {
      row.Lowest[column] = Below(lowest);
      row.Highest[column] = Above(highest);
    }
  }

  // A voxel on the border of two rows of cells belongs to both.
  void Join(int y, const MacrocellRow& row, MacrocellRow& cells) const
  {
    for (int j = this->Lattice.FirstCell(y); j <= this->Lattice.LastCell(y, 1); ++j)
    {
      const std::size_t first = static_cast<std::size_t>(j) * this->Columns;
      for (int i = 0; i < this->Columns; ++i)
      {
        cells.Lowest[first + i] = std::min(cells.Lowest[first + i], row.Lowest[i]);
        cells.Highest[first + i] = std::max(cells.Highest[first + i], row.Highest[i]);
        cells.NonFinite[first + i] |= row.NonFinite[i];
      }
    }
  }

  static bool IsFinite(Scalar value)
  {
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      return value - value == Scalar(0);
    }
    return true;
  }

  // The nearest float that is not above, or not below.
  static float Below(Scalar value)
  {
    const float nearest = static_cast<float>(value);
    return nearest > static_cast<double>(value)
      ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
      : nearest;
  }
  static float Above(Scalar value)
  {
    const float nearest = static_cast<float>(value);
    return nearest < static_cast<double>(value)
      ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
      : nearest;
  }

  const Scalar* Scalars;
  int Stride;
  MacrocellLattice Lattice;
  int Columns;
};
}

#endif
