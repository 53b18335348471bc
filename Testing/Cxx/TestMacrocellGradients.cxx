// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The largest gradient magnitude of each macrocell, against those that VTK's shader finds at many places in it, computed
// in double: none is larger, and the bound is no larger than its allowances make it.

#include "Check.h"
#include "vtkMacrocellGrid.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{
using Place = std::array<double, 3>; // in voxels

struct Field
{
  Field(int type, const std::vector<int>& size, const std::function<double(int, int, int)>& at)
    : Size(size)
    , Scalars(vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type)))
  {
    this->Scalars->SetNumberOfTuples(static_cast<vtkIdType>(size[0]) * size[1] * size[2]);
    for (vtkIdType i = 0; i < this->Scalars->GetNumberOfTuples(); ++i)
    {
      const int x = static_cast<int>(i % size[0]), y = static_cast<int>(i / size[0] % size[1]),
                z = static_cast<int>(i / size[0] / size[1]);
      this->Scalars->SetComponent(i, 0, at(x, y, z));
    }
  }

  double At(int x, int y, int z) const
  {
    return this->Scalars->GetComponent(
      (static_cast<vtkIdType>(z) * this->Size[1] + y) * this->Size[0] + x, 0);
  }

  // As a texture of linear interpolation, clamped to its edges.
  double Interpolate(const Place& place) const
  {
    int low[3], high[3];
    double part[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double inside = std::clamp(place[axis], 0.0, this->Size[axis] - 1.0);
      low[axis] = static_cast<int>(inside);
      high[axis] = std::min(low[axis] + 1, this->Size[axis] - 1);
      part[axis] = inside - low[axis];
    }
    double value = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const bool isHigh[3] = { (corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0 };
      double weight = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        weight *= isHigh[axis] ? part[axis] : 1.0 - part[axis];
      }
      value += weight *
        this->At(isHigh[0] ? high[0] : low[0], isHigh[1] ? high[1] : low[1], isHigh[2] ? high[2] : low[2]);
    }
    return value;
  }

  // VTK's: the two points lie 1 / (n - 1) of a texture of n voxels away.
  double Magnitude(const Place& place, const double scale[3]) const
  {
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double away = this->Size[axis] / (this->Size[axis] - 1.0);
      Place front = place, back = place;
      front[axis] += away;
      back[axis] -= away;
      square += std::pow(scale[axis] * (this->Interpolate(front) - this->Interpolate(back)), 2.0);
    }
    return std::min(std::sqrt(square), 1.0);
  }

  std::vector<int> Size;
  vtkSmartPointer<vtkDataArray> Scalars;
};

const double Scale[3] = { 0.4, 0.25, 0.7 };

void SetUp(vtkMacrocellGrid* grid, const Field& field, int cellSize, const double scale[3])
{
  grid->SetCellSize(cellSize);
  grid->SetScalars(field.Scalars);
  grid->SetDimensions(field.Size.data());
  grid->SetGradientScale(scale);
  grid->Update();
  grid->UpdateGradients();
}

template <typename Function>
void ForEachCell(vtkMacrocellGrid* grid, Function function)
{
  const int* size = grid->GetGridSize();
  for (int cell = 0; cell < size[0] * size[1] * size[2]; ++cell)
  {
    function(cell % size[0], cell / size[0] % size[1], cell / size[0] / size[1]);
  }
}

// At places in a cell, its faces and its voxels among them, and where the shader's points pass a voxel.
double LargestInCell(const Field& field, const int cell[3], int cellSize, std::mt19937& random)
{
  double largest = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    Place place;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int size = field.Size[axis];
      const double end = std::min(cellSize, size - cell[axis] * cellSize);
      const double within = end * (random() / 4294967295.0);
      const double kinks[] = { within, std::floor(within), std::floor(within) + 0.5,
        std::floor(within) + 0.5 + 1.0 / (size - 1.0), std::floor(within) + 0.5 - 1.0 / (size - 1.0), end };
      place[axis] = cell[axis] * cellSize - 0.5 + std::clamp(kinks[random() % 6], 0.0, end);
    }
    largest = std::max(largest, field.Magnitude(place, Scale));
  }
  return largest;
}

// The longest central difference, the steepest step between voxels and what it counts, of a cell and a voxel more.
double BoundOfCell(const Field& field, const int cell[3], int cellSize)
{
  double longest = 0.0, steepest = 0.0;
  const auto inside = [&](int voxel, int axis) { return std::clamp(voxel, 0, field.Size[axis] - 1); };
  const int across = cellSize + 2;
  for (int i = 0; i < across * across * across; ++i)
  {
    const int steps[3] = { i % across, i / across % across, i / across / across };
    int voxel[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      voxel[axis] = inside(cell[axis] * cellSize - 1 + steps[axis], axis);
    }
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      int front[3] = { voxel[0], voxel[1], voxel[2] }, back[3] = { voxel[0], voxel[1], voxel[2] };
      front[axis] = inside(voxel[axis] + 1, axis);
      back[axis] = inside(voxel[axis] - 1, axis);
      const double here = field.At(voxel[0], voxel[1], voxel[2]),
                   ahead = field.At(front[0], front[1], front[2]),
                   behind = field.At(back[0], back[1], back[2]);
      const double excess = 2.0 * Scale[axis] * (1.0 / (field.Size[axis] - 1.0) + 1.0 / 256.0);
      square += std::pow(Scale[axis] * (ahead - behind), 2.0);
      steepest = std::max({ steepest, excess * std::abs(ahead - here), excess * std::abs(here - behind) });
    }
    longest = std::max(longest, square);
  }
  const bool isRounded = field.Scalars->GetDataTypeSize() <= 2 && steepest > 0.0;
  const double rounding = isRounded ? 3.0 * std::hypot(Scale[0], Scale[1], Scale[2]) : 0.0;
  return std::min(std::sqrt(longest) + std::sqrt(3.0) * steepest + rounding, 1.0);
}

void CheckField(Check& check, const std::string& name, const Field& field, int cellSize)
{
  vtkNew<vtkMacrocellGrid> grid;
  SetUp(grid, field, cellSize, Scale);
  std::mt19937 random(3);
  ForEachCell(grid, [&](int i, int j, int k) {
    const int cell[3] = { i, j, k };
    const double found = grid->GetCellGradient(i, j, k);
    check.AtLeast(name + ": a cell's magnitude", found, LargestInCell(field, cell, cellSize, random));
    check.Near(name + ": a cell's bound", found, BoundOfCell(field, cell, cellSize), 2.0e-5);
  });
}

// A field of all types whose values fit them; magnitudes up to 1 in each.
void TestFields(Check& check)
{
  std::mt19937 random(1);
  const auto noise = [&](int, int, int) { return random() / 4294967296.0; };
  const auto bowl = [](int x, int y, int z) { return 0.002 * (x * x + 2 * y * y + 3 * z * z); };
  const auto ramp = [](int x, int, int) { return 0.3 * x; };
  for (const std::vector<int>& size :
    std::vector<std::vector<int>>{ { 9, 14, 7 }, { 2, 3, 4 }, { 16, 5, 12 } })
  {
    for (const int cellSize : { 2, 4 })
    {
      const std::string name = std::to_string(size[0]) + " voxels";
      CheckField(check, "noise of " + name, Field(VTK_FLOAT, size, noise), cellSize);
      CheckField(check, "bowl of " + name, Field(VTK_DOUBLE, size, bowl), cellSize);
      CheckField(check, "ramp of " + name, Field(VTK_FLOAT, size, ramp), cellSize);
    }
  }
}

// One code more behind a plane, far from the next plane: magnitudes are much below 1 by another scale.
void TestCodes(Check& check)
{
  for (const int type :
    { VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_LONG })
  {
    const Field field(type, { 20, 20, 20 }, [](int x, int, int) { return x > 9 ? 7.0 : 3.0; });
    const double fine[3] = { 0.01, 0.01, 0.01 };
    vtkNew<vtkMacrocellGrid> grid;
    SetUp(grid, field, 4, fine);
    const double steps = 4.0 * (0.01 + std::sqrt(3.0) * 0.02 * (1.0 / 19.0 + 1.0 / 256.0));
    const double rounding = field.Scalars->GetDataTypeSize() <= 2 ? 3.0 * std::sqrt(3.0) * 0.01 : 0.0;
    check.Near("a step of codes", grid->GetCellGradient(2, 1, 1), steps + rounding, 1.0e-6);
    check.Near("no step", grid->GetCellGradient(0, 1, 1), 0.0, 0.0);
  }
}

// Where a voxel is no number, and where one can't tell, any magnitude is possible.
void TestUnknown(Check& check)
{
  for (const double odd :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    Field field(VTK_FLOAT, { 16, 16, 16 }, [](int, int, int) { return 0.5; });
    field.Scalars->SetComponent((6 * 16 + 6) * 16 + 6, 0, odd);
    vtkNew<vtkMacrocellGrid> grid;
    SetUp(grid, field, 4, Scale);
    ForEachCell(grid, [&](int i, int j, int k) {
      // up to two voxels away on an axis, and one on the others
      const int cell[3] = { i, j, k };
      const bool isNear = std::all_of(cell, cell + 3, [](int c) { return c == 1 || c == 2; });
      const bool isReached =
        std::all_of(cell, cell + 3, [](int c) { return c == 1; }) || (isNear && i + j + k == 4);
      check.That(!isReached || grid->GetCellGradient(i, j, k) == 1.0F, "beside what is no number");
      check.That(isNear || grid->GetCellGradient(i, j, k) == 0.0F, "away from what is no number");
    });
  }
  const Field flat(VTK_FLOAT, { 8, 1, 8 }, [](int x, int, int) { return 0.001 * x; });
  vtkNew<vtkMacrocellGrid> grid;
  SetUp(grid, flat, 4, Scale);
  check.Near("a volume of one voxel on an axis", grid->GetCellGradient(1, 0, 1), 1.0, 0.0);
}

void TestUpdates(Check& check)
{
  const Field field(VTK_FLOAT, { 8, 8, 8 }, [](int x, int, int) { return 0.01 * x; });
  vtkNew<vtkMacrocellGrid> grid;
  grid->UpdateGradients();
  check.That(grid->GetMemorySize() == 0, "gradients of no scalars");
  SetUp(grid, field, 4, Scale);
  check.Near("memory", static_cast<double>(grid->GetMemorySize()), 14.0 * 8, 0.0);
  check.AtMost("a gradient", grid->GetCellGradient(0, 0, 0), 0.5);
  field.Scalars->SetComponent(0, 0, 5.0);
  field.Scalars->Modified();
  grid->Update();
  check.Near("a gradient not yet found", grid->GetCellGradient(0, 0, 0), 1.0, 0.0);
  check.Near("memory without gradients", static_cast<double>(grid->GetMemorySize()), 10.0 * 8, 0.0);
  grid->UpdateGradients();
  check.Near("a changed scalar", grid->GetCellGradient(0, 0, 0), 1.0, 0.0);
  check.AtMost("an unchanged one", grid->GetCellGradient(1, 1, 1), 0.5);
}
}

int TestMacrocellGradients(int, char*[])
{
  Check check;
  TestFields(check);
  TestCodes(check);
  TestUnknown(check);
  TestUpdates(check);
  return check.ExitCode();
}
