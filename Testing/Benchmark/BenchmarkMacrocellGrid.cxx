// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of vtkMacrocellGrid: finding the ranges of a volume and its gradients, classifying them after a change of the
// transfer function, the distances included, and estimating what skipping is worth; scalar types, sizes of cells, threads.
// CPU time is the process's.
//
//   BenchmarkMacrocellGrid [--size voxels] [Google Benchmark's options]

#include "SkippingCost.h"
#include "VisibleScalars.h"
#include "vtkMacrocellGrid.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
int Size = 512;
const double GradientScale[3] = { 0.01, 0.01, 0.01 };

struct Case
{
  int Type;
  int CellSize;
  int Threads;
};

// Waves in [0, 100].
vtkSmartPointer<vtkDataArray> MakeScalars(int type)
{
  auto scalars = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(Size) * Size * Size);
  std::vector<double> wave(Size);
  for (int i = 0; i < Size; ++i)
  {
    wave[i] = std::sin(0.05 * i);
  }
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double value = wave[i % Size] * wave[i / Size % Size] * wave[i / Size / Size];
    scalars->SetComponent(i, 0, 50.0 + 50.0 * value);
  }
  return scalars;
}

void SetUp(vtkMacrocellGrid* grid, vtkDataArray* scalars, const Case& c)
{
  vtkSMPTools::Initialize(c.Threads);
  grid->SetCellSize(c.CellSize);
  grid->SetScalars(scalars);
  grid->SetDimensions(Size, Size, Size);
}

void FindRanges(benchmark::State& state, Case c, vtkDataArray* scalars)
{
  vtkNew<vtkMacrocellGrid> grid;
  SetUp(grid, scalars, c);
  for (auto _ : state)
  {
    grid->Modified();
    benchmark::DoNotOptimize(grid->Update());
  }
  state.counters["MiB"] = static_cast<double>(grid->GetMemorySize()) / 1048576.0;
}

void FindGradients(benchmark::State& state, Case c, vtkDataArray* scalars)
{
  vtkNew<vtkMacrocellGrid> grid;
  SetUp(grid, scalars, c);
  grid->SetGradientScale(GradientScale);
  for (auto _ : state)
  {
    state.PauseTiming();
    grid->Modified();
    grid->Update();
    state.ResumeTiming();
    grid->UpdateGradients();
  }
  state.counters["MiB"] = static_cast<double>(grid->GetMemorySize()) / 1048576.0;
}

void Classify(benchmark::State& state, Case c, vtkDataArray* scalars)
{
  vtkNew<vtkMacrocellGrid> grid;
  SetUp(grid, scalars, c);
  grid->Update();
  std::vector<float> table(1024, 0.0F);
  std::fill(table.begin() + 900, table.end(), 0.5F);
  const double range[2] = { 0.0, 100.0 };
  for (auto _ : state)
  {
    const VisibleScalars visible(table, range, VisibleScalars::Ends::Edges);
    grid->Classify(visible, visible);
  }
  state.counters["empty"] = grid->GetEmptyFraction();
}

// What half of the cells see through, so that rays are long.
void Estimate(benchmark::State& state, Case c, vtkDataArray* scalars)
{
  vtkNew<vtkMacrocellGrid> grid;
  SetUp(grid, scalars, c);
  grid->Update();
  std::vector<float> table(1024, 0.0F);
  std::fill(table.begin() + 512, table.end(), 0.001F);
  const double range[2] = { 0.0, 100.0 };
  const VisibleScalars visible(table, range, VisibleScalars::Ends::Edges);
  grid->Classify(visible, visible);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(EstimateSkipping(grid, visible, 1.0, { 1.2, 0.27, 2.4, 0.18 }));
  }
  state.counters["empty"] = grid->GetEmptyFraction();
}

// Every scalar is seen, and steep places alone.
void ClassifyGradients(benchmark::State& state, Case c, vtkDataArray* scalars)
{
  vtkNew<vtkMacrocellGrid> grid;
  SetUp(grid, scalars, c);
  grid->SetGradientScale(GradientScale);
  grid->Update();
  grid->UpdateGradients();
  const std::vector<float> table(1024, 0.5F), least(1024, 0.08F);
  const double range[2] = { 0.0, 100.0 };
  for (auto _ : state)
  {
    const VisibleScalars visible(table, range, VisibleScalars::Ends::Edges, least);
    grid->Classify(visible, visible);
  }
  state.counters["empty"] = grid->GetEmptyFraction();
}

void Register(const std::string& name, void (*function)(benchmark::State&, Case, vtkDataArray*),
  const Case& c, vtkDataArray* scalars)
{
  benchmark::RegisterBenchmark((name + "/" + scalars->GetDataTypeAsString() + "/cells of " +
                                 std::to_string(c.CellSize) + "/" + std::to_string(c.Threads) + " threads")
                                 .c_str(),
    function, c, scalars)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
}
}

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  if (argc == 3 && std::string(argv[1]) == "--size")
  {
    Size = std::stoi(argv[2]);
  }
  std::vector<vtkSmartPointer<vtkDataArray>> volumes;
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT })
  {
    volumes.push_back(MakeScalars(type));
    for (const int cellSize : { 8, 16 })
    {
      for (const int threads : { 1, 2 })
      {
        Register("Ranges", FindRanges, { type, cellSize, threads }, volumes.back());
        Register("Gradients", FindGradients, { type, cellSize, threads }, volumes.back());
        Register("ClassifyGradients", ClassifyGradients, { type, cellSize, threads }, volumes.back());
        Register("Classify", Classify, { type, cellSize, threads }, volumes.back());
      }
      Register("Estimate", Estimate, { type, cellSize, 1 }, volumes.back());
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
