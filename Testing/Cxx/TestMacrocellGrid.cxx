// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Macrocells of random fields, of every scalar type: ranges, emptiness and distances are those of a search through
// all voxels and cells.

#include "Check.h"
#include "VisibleScalars.h"
#include "vtkMacrocellGrid.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
const int Sizes[][3] = { { 1, 1, 1 }, { 2, 3, 4 }, { 8, 8, 8 }, { 9, 17, 16 }, { 30, 7, 21 } };

struct Field
{
  Field(int type, const int size[3], int components, unsigned int seed)
    : Scalars(vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type)))
  {
    std::copy(size, size + 3, this->Size);
    this->Scalars->SetNumberOfComponents(components);
    this->Scalars->SetNumberOfTuples(static_cast<vtkIdType>(size[0]) * size[1] * size[2]);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(0.0, 100.0);
    for (vtkIdType i = 0; i < this->Scalars->GetNumberOfValues(); ++i)
    {
      this->Scalars->SetComponent(i / components, i % components, value(random));
    }
  }

  double At(int x, int y, int z, int component) const
  {
    return this->Scalars->GetComponent(
      (static_cast<vtkIdType>(z) * this->Size[1] + y) * this->Size[0] + x, component);
  }

  void SetUp(vtkMacrocellGrid* grid, int cellSize, int component) const
  {
    grid->SetCellSize(cellSize);
    grid->SetScalars(this->Scalars);
    grid->SetDimensions(this->Size[0], this->Size[1], this->Size[2]);
    grid->SetComponent(component);
  }

  vtkSmartPointer<vtkDataArray> Scalars;
  int Size[3];
};

struct Cell
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
  bool HasNonFinite = false;
};

// The voxels from one before the cell to one behind it.
Cell Search(const Field& field, const int cell[3], int cellSize, int component)
{
  Cell found;
  int begin[3], end[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    begin[axis] = std::max(cell[axis] * cellSize - 1, 0);
    end[axis] = std::min((cell[axis] + 1) * cellSize, field.Size[axis] - 1);
  }
  for (int z = begin[2]; z <= end[2]; ++z)
  {
    for (int y = begin[1]; y <= end[1]; ++y)
    {
      for (int x = begin[0]; x <= end[0]; ++x)
      {
        const double value = field.At(x, y, z, component);
        found.HasNonFinite |= !std::isfinite(value);
        found.Low = value < found.Low ? value : found.Low;
        found.High = value > found.High ? value : found.High;
      }
    }
  }
  return found;
}

template <typename Function>
void ForEachCell(vtkMacrocellGrid* grid, Function function)
{
  const int* size = grid->GetGridSize();
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const int cell[3] = { i, j, k };
        function(cell);
      }
    }
  }
}

void CheckRanges(Check& check, const Field& field, int cellSize, int component)
{
  vtkNew<vtkMacrocellGrid> grid;
  field.SetUp(grid, cellSize, component);
  check.That(grid->Update(), "the grid is not made");
  const std::string name = std::string(field.Scalars->GetClassName()) + " of " +
    std::to_string(field.Size[0]) + ", cells of " + std::to_string(cellSize);
  ForEachCell(grid, [&](const int cell[3]) {
    const Cell expected = Search(field, cell, cellSize, component);
    double range[2];
    grid->GetCellRange(cell[0], cell[1], cell[2], range);
    // a float beside the number, outwards
    const double rounding = std::numeric_limits<float>::epsilon() * 100.0;
    check.That(range[0] <= expected.Low, name + ": a range begins late");
    check.That(range[1] >= expected.High, name + ": a range ends early");
    if (expected.Low <= expected.High && std::isfinite(expected.High - expected.Low))
    {
      check.Near(name + ": lowest", range[0], expected.Low, rounding);
      check.Near(name + ": highest", range[1], expected.High, rounding);
    }
    check.That(grid->GetCellHasNonFinite(cell[0], cell[1], cell[2]) == expected.HasNonFinite,
      name + ": a scalar that is not finite");
  });
}

void TestRanges(Check& check)
{
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
         VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    for (const auto& size : Sizes)
    {
      CheckRanges(check, Field(type, size, 1, 1), 4, 0);
    }
  }
  CheckRanges(check, Field(VTK_DOUBLE, Sizes[4], 3, 2), 8, 2);
  CheckRanges(check, Field(VTK_UNSIGNED_CHAR, Sizes[4], 4, 3), 2, 3);
  CheckRanges(check, Field(VTK_UNSIGNED_CHAR, Sizes[4], 1, 4), 64, 0);
}

void TestNonFinite(Check& check)
{
  const double oddities[] = { vtkMath::Nan(), vtkMath::Inf(), vtkMath::NegInf() };
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    Field field(type, Sizes[4], 1, 5);
    for (vtkIdType i = 0; i < field.Scalars->GetNumberOfTuples(); i += 997)
    {
      field.Scalars->SetComponent(i, 0, oddities[i % 3]);
    }
    CheckRanges(check, field, 4, 0);
  }
}

// Visible from 30 to 35 and from 60 on; the range of coordinates is [0, 100].
VisibleScalars SomeScalars()
{
  std::vector<float> table(1024, 0.0F);
  std::fill(table.begin() + 307, table.begin() + 358, 0.5F);
  std::fill(table.begin() + 614, table.end(), 0.1F);
  const double range[2] = { 0.0, 100.0 };
  return VisibleScalars(table, range, VisibleScalars::Ends::Edges);
}

// Clusters, so that there are distances.
Field ClusteredField(const int size[3], unsigned int seed)
{
  Field field(VTK_FLOAT, size, 1, seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<vtkIdType> voxel(0, field.Scalars->GetNumberOfTuples() - 1);
  field.Scalars->Fill(10.0);
  for (int i = 0; i < 3; ++i)
  {
    field.Scalars->SetComponent(voxel(random), 0, 33.0);
  }
  return field;
}

int Nearest(vtkMacrocellGrid* grid, const std::vector<bool>& isEmpty, const int cell[3])
{
  int nearest = 255;
  std::size_t index = 0;
  ForEachCell(grid, [&](const int other[3]) {
    if (!isEmpty[index++])
    {
      nearest = std::min(nearest,
        std::max(
          { std::abs(other[0] - cell[0]), std::abs(other[1] - cell[1]), std::abs(other[2] - cell[2]) }));
    }
  });
  return nearest;
}

void CheckClassification(Check& check, const Field& field, bool emptyWhereConstant)
{
  vtkNew<vtkMacrocellGrid> grid;
  field.SetUp(grid, 2, 0);
  grid->Update();
  const VisibleScalars visible = SomeScalars();
  const double range[2] = { 0.0, 100.0 };
  const VisibleScalars nothing(std::vector<float>(2, 0.0F), range, VisibleScalars::Ends::Edges);
  grid->Classify(visible, emptyWhereConstant ? nothing : visible);
  std::vector<bool> isEmpty;
  ForEachCell(grid, [&](const int cell[3]) {
    const Cell found = Search(field, cell, 2, 0);
    const bool isConstant = emptyWhereConstant && found.Low == found.High;
    isEmpty.push_back(isConstant || !visible.HasAny(found.Low, found.High));
  });
  const auto empty = std::count(isEmpty.begin(), isEmpty.end(), true);
  check.Near(
    "empty fraction", grid->GetEmptyFraction(), static_cast<double>(empty) / isEmpty.size(), 1.0e-15);
  int deep = 0;
  ForEachCell(grid, [&](const int cell[3]) { deep += Nearest(grid, isEmpty, cell) > 1 ? 1 : 0; });
  check.Near(
    "deep empty fraction", grid->GetDeepEmptyFraction(), static_cast<double>(deep) / isEmpty.size(), 1.0e-15);
  int found[6] = { VTK_INT_MAX, -1, VTK_INT_MAX, -1, VTK_INT_MAX, -1 }, visibleExtent[6];
  ForEachCell(grid, [&](const int cell[3]) {
    for (int side = 0; side < 6 && grid->GetCellDistance(cell[0], cell[1], cell[2]) == 0; ++side)
    {
      found[side] =
        side % 2 == 0 ? std::min(found[side], cell[side / 2]) : std::max(found[side], cell[side / 2]);
    }
  });
  grid->GetVisibleExtent(visibleExtent);
  check.That(std::equal(found, found + 6, visibleExtent), "extent of the cells that are not empty");
  ForEachCell(grid, [&](const int cell[3]) {
    check.That(
      grid->GetCellDistance(cell[0], cell[1], cell[2]) == Nearest(grid, isEmpty, cell), "a cell's distance");
  });
}

void TestClassification(Check& check)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    const int size[3] = { 5 + static_cast<int>(seed) % 9, 17, 23 - static_cast<int>(seed) };
    CheckClassification(check, ClusteredField(size, seed), false);
    CheckClassification(check, Field(VTK_FLOAT, size, 1, seed), false);
  }
  Field constant(VTK_FLOAT, Sizes[3], 1, 1);
  constant.Scalars->Fill(33.0);
  CheckClassification(check, constant, false);
  constant.Scalars->SetComponent(700, 0, 34.0);
  CheckClassification(check, constant, true);
}

void TestUpdates(Check& check)
{
  const int size[3] = { 64, 64, 64 };
  const Field field(VTK_SHORT, size, 1, 1);
  vtkNew<vtkMacrocellGrid> grid;
  field.SetUp(grid, 8, 0);
  int events = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&events);
  count->SetCallback([](vtkObject*, unsigned long, void* client, void* progress) {
    const double done = *static_cast<double*>(progress);
    *static_cast<int*>(client) += done > 0.0 && done <= 1.0 ? 1 : 1000;
  });
  grid->AddObserver(vtkCommand::ProgressEvent, count);
  grid->Update();
  check.That(events >= 4 && events < 1000, "progress is told " + std::to_string(events) + " times");
  const vtkMTimeType time = grid->GetUpdateTime();
  grid->Update();
  check.That(grid->GetUpdateTime() == time, "an update without a change");
  field.Scalars->SetComponent(5, 0, 101.0);
  field.Scalars->Modified();
  grid->Update();
  double range[2];
  grid->GetCellRange(0, 0, 0, range);
  check.Near("a changed scalar", range[1], 101.0, 0.0);
  // two floats and two bytes a cell
  check.Near("memory", static_cast<double>(grid->GetMemorySize()), 10.0 * 8 * 8 * 8, 0.0);
}

// By one thread and by several.
void TestThreads(Check& check)
{
  const int size[3] = { 64, 40, 64 };
  const Field field(VTK_FLOAT, size, 1, 5);
  std::vector<double> ranges[2];
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, [&]() {
      vtkNew<vtkMacrocellGrid> grid;
      field.SetUp(grid, 4, 0);
      grid->Update();
      ForEachCell(grid, [&](const int cell[3]) {
        double range[2];
        grid->GetCellRange(cell[0], cell[1], cell[2], range);
        ranges[threads > 1].insert(ranges[threads > 1].end(), range, range + 2);
      });
    });
  }
  check.That(!ranges[0].empty() && ranges[0] == ranges[1], "threads find other ranges");
}

void TestErrors(Check& check)
{
  vtkNew<vtkMacrocellGrid> grid;
  vtkNew<vtkTest::ErrorObserver> errors;
  grid->AddObserver(vtkCommand::ErrorEvent, errors);
  check.That(!grid->Update() && errors->GetError(), "a grid of no scalars");
  errors->Clear();
  check.That(!grid->Update() && !errors->GetError(), "the error is told twice");
  const Field field(VTK_FLOAT, Sizes[1], 1, 1);
  field.SetUp(grid, 8, 1);
  check.That(!grid->Update() && errors->GetError(), "a component that is not there");
  errors->Clear();
  field.SetUp(grid, 8, 0);
  grid->SetDimensions(2, 3, 5);
  check.That(!grid->Update() && errors->GetError(), "dimensions that do not fit");
  check.That(grid->GetMemorySize() == 0, "memory of an empty grid");
  errors->Clear();
  grid->SetDimensions(2, 3, 4);
  check.That(grid->Update() && !errors->GetError(), "a grid after errors");
}

void TestAutomaticCells(Check& check)
{
  const int expected[][4] = { { 1, 1, 1, 2 }, { 128, 128, 128, 2 }, { 129, 128, 128, 4 },
    { 256, 256, 108, 4 }, { 512, 512, 512, 8 }, { 4096, 4096, 4096, 64 }, { 46340, 46340, 46340, 64 } };
  for (const auto& size : expected)
  {
    check.That(vtkMacrocellGrid::FindCellSize(size) == size[3],
      "automatic cells of " + std::to_string(size[0]) + " voxels on x");
  }
}
}

int TestMacrocellGrid(int, char*[])
{
  Check check;
  TestAutomaticCells(check);
  TestRanges(check);
  TestNonFinite(check);
  TestClassification(check);
  TestUpdates(check);
  TestThreads(check);
  TestErrors(check);
  return check.ExitCode();
}
