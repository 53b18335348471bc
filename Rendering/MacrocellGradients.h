// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The largest gradient magnitude that a ray can meet in each cell of one layer of macrocells. VTK's shader takes the
// difference of the interpolated scalar between two points that lie 1 / (n - 1) of the texture's n voxels away on both
// sides, so 1 / (n - 1) of a voxel more than one. Without that excess it is, at any sample, a mean of the central
// differences at the eight voxels around, and no longer than the longest of them. The excess adds at most what the
// steepest step from voxel to voxel does on its length, and so does the fraction to which textures round a place.

#ifndef MacrocellGradients_h
#define MacrocellGradients_h

#include "MacrocellRanges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace volumeoptics
{
// Of 1 - which is what VTK clamps to - and what is no number, 1.
inline float UpToOne(float value)
{
  return value < 1.0F ? value : 1.0F;
}

// Scaled: squares of the central differences of a row of voxels, and the largest step to a neighbour. rows: the voxels
// themselves, with one more at both ends, those before and behind them on y, and those on z. One thing in each loop, of
// few arrays: so compilers take several voxels at once.
void FindGradientSquares(
  const float* const rows[5], int size, const std::array<float, 3>& scale, float* squares);
void FindLargestSteps(const float* const rows[5], int size, const std::array<float, 3>& scale, float* steps);

/** Each the larger of both. */
void EnlargeBounds(float* largest, const float* values, int size);

template <typename Scalar>
class MacrocellGradients
{
public:
  // scale: magnitude of a difference of 1 between the two neighbours on each axis.
  MacrocellGradients(
    const Scalar* scalars, int stride, const MacrocellLattice& lattice, const double scale[3])
    : Scalars(scalars)
    , Stride(stride)
    , Lattice(lattice)
  {
    double squares = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double excess = 1.0 / (lattice.Dimensions[axis] - 1.0) + TextureFraction;
      this->Scale[axis] = static_cast<float>(scale[axis]);
      this->StepScale[axis] = static_cast<float>(2.0 * excess * scale[axis]);
      squares += scale[axis] * scale[axis];
    }
    this->Rounding = sizeof(Scalar) <= 2 ? static_cast<float>(FilterRounding * std::sqrt(squares)) : 0.0F;
  }

  std::vector<float> Find(int layer) const
  {
    const int width = this->Lattice.Dimensions[0];
    Bounds slabs(static_cast<std::size_t>(width) * this->Lattice.CellsOn(1)), row(width);
    const int begin = this->Lattice.FirstVoxel(layer), end = this->Lattice.EndVoxel(layer, 2);
    std::vector<float> below, here, above;
    this->FillPlane(begin - 1, below);
    this->FillPlane(begin, here);
    for (int z = begin; z < end; ++z)
    {
      this->FillPlane(z + 1, above);
      for (int y = 0; y < this->Lattice.Dimensions[1]; ++y)
      {
        this->Differentiate(y, below, here, above, row);
        this->Join(y, row, slabs);
      }
      below.swap(here);
      here.swap(above);
    }
    return this->Reduce(slabs);
  }

private:
  // The largest of voxels that are side by side on x, of a row or of all rows in a cell.
  struct Bounds
  {
    explicit Bounds(std::size_t size)
      : Squares(size, 0.0F)
      , Steps(size, 0.0F)
    {
    }
    std::vector<float> Squares; // of central differences
    std::vector<float> Steps;   // to a neighbour on an axis, times the excess
  };

  float Magnitude(float square, float step) const
  {
    const float rounding = step > 0.0F ? this->Rounding : 0.0F; // what is constant is interpolated exactly
    return UpToOne((std::sqrt(square) + AllAxes * step + rounding) * (1.0F + 1.0e-5F));
  }

  int PlaneWidth() const { return this->Lattice.Dimensions[0] + 2; }

  // A plane of voxels as the texture's floats, clamped to the volume, with one more at both ends of each row.
  void FillPlane(int z, std::vector<float>& plane) const
  {
    const int width = this->Lattice.Dimensions[0], height = this->Lattice.Dimensions[1];
    const std::size_t inside = std::clamp(z, 0, this->Lattice.Dimensions[2] - 1);
    plane.resize(static_cast<std::size_t>(this->PlaneWidth()) * height);
    const Scalar* scalar = this->Scalars + inside * width * height * this->Stride;
    for (float* row = plane.data(); row != plane.data() + plane.size(); row += width + 2)
    {
      for (int x = 0; x < width; ++x, scalar += this->Stride)
      {
        row[x + 1] = static_cast<float>(*scalar);
      }
      row[0] = row[1];
      row[width + 1] = row[width];
    }
  }

  const float* RowOf(const std::vector<float>& plane, int y) const
  {
    const std::size_t inside = std::clamp(y, 0, this->Lattice.Dimensions[1] - 1);
    return plane.data() + inside * this->PlaneWidth() + 1;
  }

  void Differentiate(int y, const std::vector<float>& planeBelow, const std::vector<float>& plane,
    const std::vector<float>& planeAbove, Bounds& row) const
  {
    const float *here = this->RowOf(plane, y), *front = this->RowOf(plane, y - 1),
                *back = this->RowOf(plane, y + 1), *below = this->RowOf(planeBelow, y),
                *above = this->RowOf(planeAbove, y);
    const float* const rows[5] = { here, front, back, below, above };
    FindGradientSquares(rows, this->Lattice.Dimensions[0], this->Scale, row.Squares.data());
    FindLargestSteps(rows, this->Lattice.Dimensions[0], this->StepScale, row.Steps.data());
  }

  // A voxel on the border of two rows of cells belongs to both.
  void Join(int y, const Bounds& row, Bounds& slabs) const
  {
    const int width = this->Lattice.Dimensions[0];
    for (int j = this->Lattice.FirstCell(y); j <= this->Lattice.LastCell(y, 1); ++j)
    {
      float* squares = slabs.Squares.data() + static_cast<std::size_t>(j) * width;
      float* steps = slabs.Steps.data() + static_cast<std::size_t>(j) * width;
      EnlargeBounds(squares, row.Squares.data(), width);
      EnlargeBounds(steps, row.Steps.data(), width);
    }
  }

  std::vector<float> Reduce(const Bounds& slabs) const
  {
    std::vector<float> magnitudes;
    for (int j = 0; j < this->Lattice.CellsOn(1); ++j)
    {
      const std::size_t first = static_cast<std::size_t>(j) * this->Lattice.Dimensions[0];
      for (int i = 0; i < this->Lattice.CellsOn(0); ++i)
      {
        const auto largest = [&](const std::vector<float>& values) {
          const auto row = values.begin() + first;
          return *std::max_element(row + this->Lattice.FirstVoxel(i), row + this->Lattice.EndVoxel(i, 0));
        };
        magnitudes.push_back(this->Magnitude(largest(slabs.Squares), largest(slabs.Steps)));
      }
    }
    return magnitudes;
  }

  static constexpr double TextureFraction =
    1.0 / 256.0;                                // of a voxel, the coarsest that OpenGL's drivers round to
  static constexpr double FilterRounding = 3.0; // codes, of three interpolations in whole codes
  static constexpr float AllAxes = 1.7320509F;  // root of 3

  const Scalar* Scalars;
  int Stride;
  MacrocellLattice Lattice;
  std::array<float, 3> Scale;
  std::array<float, 3> StepScale;
  float Rounding;
};
}

#endif
