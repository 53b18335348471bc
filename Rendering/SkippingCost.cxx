// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SkippingCost.h"

#include "VisibleScalars.h"
#include "vtkMacrocellGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
const int WantedRows = 256; // on each axis
const int MostRowsPerRay = 16;
const double ManyCells = 262144.0;
const double SamplesPerVoxel =
  2.0; // fixed, lest programs be linked when the step changes while the camera moves
const double LeastTransmittance = 1.0 / 255.0; // where VTK ends a ray

class RowCost
{
public:
  RowCost(
    vtkMacrocellGrid* grid, const VisibleScalars& visible, double voxelsPerUnit, const SkippingTimes& times)
    : Grid(grid)
    , Visible(visible)
    , UnitsPerCell(voxelsPerUnit > 0.0 ? grid->GetCellSize() / voxelsPerUnit : 0.0)
    , Samples(grid->GetCellSize() * SamplesPerVoxel)
    , Times(times)
  {
    this->Times.Seen += times.SeenInMany * static_cast<double>(grid->GetDistances().size()) / ManyCells;
  }

  void Add(int axis, bool isForth, int cell[3])
  {
    const int size = this->Grid->GetGridSize()[axis];
    double transmittance = 1.0;
    for (int n = 0; n < size && transmittance > LeastTransmittance;)
    {
      cell[axis] = isForth ? n : size - 1 - n;
      const int distance = this->Grid->GetCellDistance(cell[0], cell[1], cell[2]);
      const int cells = std::clamp(distance, 1, size - n);
      const double samples = cells * this->Samples;
      this->Plain += samples;
      this->Skipping +=
        distance == 0 ? samples * this->Times.Seen : this->Times.LookUp + samples * this->Times.Step;
      transmittance *= distance == 0 ? this->Transmittance(cell) : 1.0;
      n += cells;
    }
  }

  double Ratio() const { return this->Plain > 0.0 ? this->Skipping / this->Plain : 1.0; }

private:
  double Transmittance(const int cell[3]) const
  {
    double range[2];
    this->Grid->GetCellRange(cell[0], cell[1], cell[2], range);
    const float gradient = this->Grid->GetCellGradient(cell[0], cell[1], cell[2]);
    return this->UnitsPerCell > 0.0 && range[0] <= range[1]
      ? std::pow(1.0 - this->Visible.MeanOpacity(range[0], range[1], gradient), this->UnitsPerCell)
      : 1.0;
  }

  vtkMacrocellGrid* Grid;
  const VisibleScalars& Visible;
  double UnitsPerCell;
  double Samples; // in a cell
  SkippingTimes Times;
  double Plain = 0.0;
  double Skipping = 0.0;
};
}

//------------------------------------------------------------------------------
double EstimateSkipping(
  vtkMacrocellGrid* grid, const VisibleScalars& visible, double voxelsPerUnit, const SkippingTimes& times)
{
  RowCost cost(grid, visible, voxelsPerUnit, times);
  const int* size = grid->GetGridSize();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int across = (axis + 1) % 3, up = (axis + 2) % 3;
    const int rowsPerRay = std::clamp(size[across] * size[up] / WantedRows, 1, MostRowsPerRay);
    int cell[3];
    for (cell[up] = 0; cell[up] < size[up]; ++cell[up])
    {
      // a lattice of all phases, lest a regular pattern be met at some alone
      for (cell[across] = 5 * cell[up] % rowsPerRay; cell[across] < size[across]; cell[across] += rowsPerRay)
      {
        cost.Add(axis, true, cell);
        cost.Add(axis, false, cell);
      }
    }
  }
  return cost.Ratio();
}
