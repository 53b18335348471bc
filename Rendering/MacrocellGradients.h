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
#include <cmath>
#include <vector>

namespace volumeoptics
{
// Of 1 - which is what VTK clamps to - and what is no number, 1.
inline float UpToOne(float value)
{
  return value < 1.0F ? value : 1.0F;
}

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
    const std::size_t size = static_cast<std::size_t>(this->Lattice.CellsOn(0)) * this->Lattice.CellsOn(1);
    Row cells(size);
    const int begin = this->Lattice.FirstVoxel(layer), end = this->Lattice.EndVoxel(layer, 2);
    std::vector<float> below = this->Plane(begin - 1), here = this->Plane(begin), above;
    for (int z = begin; z < end; ++z)
    {
      above = this->Plane(z + 1);
      for (int y = 0; y < this->Lattice.Dimensions[1]; ++y)
      {
        this->Join(y, this->Reduce(y, below, here, above), cells);
      }
      below.swap(here);
      here.swap(above);
    }
    std::vector<float> magnitudes(size);
    std::transform(cells.Squares.begin(), cells.Squares.end(), cells.Steps.begin(), magnitudes.begin(),
      [this](float square, float step) { return this->Magnitude(square, step); });
    return magnitudes;
  }

private:
  // Side by side, of voxels or of cells.
  struct Row
  {
    explicit Row(std::size_t size)
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
  std::vector<float> Plane(int z) const
  {
    const int width = this->Lattice.Dimensions[0], height = this->Lattice.Dimensions[1];
    const std::size_t inside = std::clamp(z, 0, this->Lattice.Dimensions[2] - 1);
    std::vector<float> plane(static_cast<std::size_t>(this->PlaneWidth()) * height);
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
    return plane;
  }

  // The voxels of a row, then the cells.
  Row Reduce(int y, const std::vector<float>& below, const std::vector<float>& here,
    const std::vector<float>& above) const
  {
    const int width = this->Lattice.Dimensions[0];
    const auto row = [&](const std::vector<float>& plane, int at) {
      return plane.data() +
        static_cast<std::size_t>(std::clamp(at, 0, this->Lattice.Dimensions[1] - 1)) * this->PlaneWidth() + 1;
    };
    const float* const lines[5] = { row(here, y), row(here, y - 1), row(here, y + 1), row(below, y),
      row(above, y) };
    Row voxels(width);
    this->Differentiate(lines, voxels);
    Row cells(this->Lattice.CellsOn(0));
    for (int column = 0; column < this->Lattice.CellsOn(0); ++column)
    {
      const int begin = this->Lattice.FirstVoxel(column), end = this->Lattice.EndVoxel(column, 0);
      const auto largest = [=](const std::vector<float>& values) {
        return *std::max_element(values.begin() + begin, values.begin() + end);
      };
      cells.Squares[column] = largest(voxels.Squares);
      cells.Steps[column] = largest(voxels.Steps);
    }
    return cells;
  }

  void Differentiate(const float* const lines[5], Row& voxels) const
  {
    const float *here = lines[0], *front = lines[1], *back = lines[2], *below = lines[3], *above = lines[4];
    for (int x = 0; x < this->Lattice.Dimensions[0]; ++x)
    {
      const float gradient[3] = { (here[x + 1] - here[x - 1]) * this->Scale[0],
        (back[x] - front[x]) * this->Scale[1], (above[x] - below[x]) * this->Scale[2] };
      voxels.Squares[x] =
        UpToOne(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2]);
      const float alongX = std::max(this->Step(0, here[x + 1], here[x]), this->Step(0, here[x], here[x - 1]));
      const float alongY = std::max(this->Step(1, back[x], here[x]), this->Step(1, here[x], front[x]));
      const float alongZ = std::max(this->Step(2, above[x], here[x]), this->Step(2, here[x], below[x]));
      voxels.Steps[x] = std::max(std::max(alongX, alongY), alongZ);
    }
  }

  float Step(int axis, float to, float from) const
  {
    return UpToOne(std::abs(to - from) * this->StepScale[axis]);
  }

  void Join(int y, const Row& row, Row& cells) const
  {
    const int columns = this->Lattice.CellsOn(0);
    for (int j = this->Lattice.FirstCell(y); j <= this->Lattice.LastCell(y, 1); ++j)
    {
      const std::size_t first = static_cast<std::size_t>(j) * columns;
      for (int i = 0; i < columns; ++i)
      {
        cells.Squares[first + i] = std::max(cells.Squares[first + i], row.Squares[i]);
        cells.Steps[first + i] = std::max(cells.Steps[first + i], row.Steps[i]);
      }
    }
  }

  static constexpr double TextureFraction =
    1.0 / 256.0;                                // of a voxel, the coarsest that OpenGL's drivers round to
  static constexpr double FilterRounding = 3.0; // codes, of three interpolations in whole codes
  static constexpr float AllAxes = 1.7320509F;  // root of 3

  const Scalar* Scalars;
  int Stride;
  MacrocellLattice Lattice;
  float Scale[3];
  float StepScale[3];
  float Rounding;
};
}

#endif
