// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The estimate of what skipping costs, of volumes of which it can be told by counting.

#include "Check.h"
#include "SkippingCost.h"
#include "VisibleScalars.h"
#include "vtkMacrocellGrid.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"

#include <functional>

namespace
{
const int Edge = 32;
const int CellSize = 4;
const double Samples = 2.0 * Edge; // of a row
const double Range[2] = { 0.0, 1.0 };
const SkippingTimes Times = { 1.5, 0.0, 4.0, 0.25 };

// Scalars of 1 where it holds, else of 0. Opacities of 0 below a scalar of 0.5, and of `opacity` above it.
double Estimate(const std::function<bool(int, int, int)>& isSeen, float opacity, double voxelsPerUnit)
{
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(Edge) * Edge * Edge);
  for (int i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetValue(i, isSeen(i % Edge, i / Edge % Edge, i / Edge / Edge) ? 1.0F : 0.0F);
  }
  vtkNew<vtkMacrocellGrid> grid;
  grid->SetScalars(scalars);
  grid->SetDimensions(Edge, Edge, Edge);
  grid->SetCellSize(CellSize);
  grid->Update();
  const VisibleScalars visible({ 0.0F, 0.0F, opacity, opacity }, Range,
    VisibleScalars::Ends::Centres); // seen between the second and third
  grid->Classify(visible, visible);
  return EstimateSkipping(grid, visible, voxelsPerUnit, Times);
}

void TestUniform(Check& check)
{
  check.Near("all seen", Estimate([](int, int, int) { return true; }, 0.1F, 0.0), Times.Seen, 1e-12);
  check.Near("all empty", Estimate([](int, int, int) { return false; }, 0.1F, 0.0),
    Times.Step + Times.LookUp / Samples, 1e-12);
}

// The upper half is seen, and with the apron the layer of cells below it: 3 of 8 layers are empty.
void TestHalf(Check& check)
{
  const auto isSeen = [](int, int, int z) { return z >= 16; };
  const double perRow = 3.0 / 8.0;
  // across the layers: up, leaps of 3 cells; down, after what is seen a leap of one cell, of two, and of three
  const double up = perRow * Samples * Times.Step + Times.LookUp + 5.0 / 8.0 * Samples * Times.Seen;
  const double down = perRow * Samples * Times.Step + 2.0 * Times.LookUp + 5.0 / 8.0 * Samples * Times.Seen;
  // along them, layers 1 to 3 away from what is seen: leaps of as many cells
  const double along =
    (5.0 * Samples * Times.Seen + 3.0 * Samples * Times.Step + (8.0 + 4.0 + 3.0) * Times.LookUp) / 8.0;
  check.Near("half", Estimate(isSeen, 0.1F, 0.0), (0.5 * (up + down) + 2.0 * along) / 3.0 / Samples, 1e-12);
}

// Rays that end in the first layer of cells that is seen do not pay for what lies behind it.
void TestOpaque(Check& check)
{
  const auto isSeen = [](int x, int y, int z) { return z >= 16 && x >= 0 && y >= 0; };
  const double through = Estimate(isSeen, 1.0F, 0.0), opaque = Estimate(isSeen, 1.0F, 0.01);
  check.That(opaque < 0.95 * through, "behind what is opaque");
  check.Near("nearly clear", Estimate(isSeen, 1e-6F, 1.0), through, 1e-12);
}
}

int TestSkippingCost(int, char*[])
{
  Check check;
  TestUniform(check);
  TestHalf(check);
  TestOpaque(check);
  return check.ExitCode();
}
