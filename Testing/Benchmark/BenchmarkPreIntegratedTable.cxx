// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of vtkPreIntegratedTable::Update() after a change: sizes, smooth and spiky transfer functions, data and
// physical space, threads. CPU time is the process's. Medians: --benchmark_repetitions=5
// --benchmark_report_aggregates_only=true.

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPreIntegratedTable.h"
#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

#include <string>

namespace
{
struct Case
{
  int Size;
  bool IsSpiky;
  double SegmentLength; // 0: data space
  int Threads;
};

// A ramp, or 16 triangles each 1/256 of the range wide with colours of their own.
void FillFunctions(const Case& c, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  const int peaks = c.IsSpiky ? 16 : 0;
  color->AddRGBPoint(0.0, 0.1, 0.3, 0.9);
  color->AddRGBPoint(1.0, 1.0, 0.6, 0.2);
  for (int i = 0; i < peaks; ++i)
  {
    const double middle = (i + 0.5) / peaks;
    opacity->AddPoint(middle - 1.0 / 512.0, 0.0);
    opacity->AddPoint(middle, 0.5);
    opacity->AddPoint(middle + 1.0 / 512.0, 0.0);
    color->AddRGBPoint(middle, i % 2, i % 3 / 2.0, i % 5 / 4.0);
  }
  if (peaks == 0)
  {
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(1.0, 0.8);
  }
}

void RunCase(benchmark::State& state, Case c)
{
  vtkSMPTools::Initialize(c.Threads);
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  FillFunctions(c, color, opacity);
  vtkNew<vtkPreIntegratedTable> table;
  table->SetColorFunction(color);
  table->SetOpacityFunction(opacity);
  table->SetSize(c.Size);
  table->SetSegmentLength(c.SegmentLength);
  for (auto _ : state)
  {
    opacity->Modified();
    benchmark::DoNotOptimize(table->Update());
  }
  state.counters["MiB"] = static_cast<double>(table->GetMemorySize()) / 1048576.0;
}

void Register(const Case& c)
{
  const std::string name = std::string(c.SegmentLength > 0.0 ? "Physical" : "Data") +
    (c.IsSpiky ? "/Spiky/" : "/Smooth/") + std::to_string(c.Size) + "/" + std::to_string(c.Threads) +
    "threads";
  benchmark::RegisterBenchmark(name.c_str(), RunCase, c)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
}
}

int main(int argc, char* argv[])
{
  for (const bool isSpiky : { false, true })
  {
    for (const int size : { 64, 128, 256, 512, 1024, 2048, 4096 })
    {
      Register({ size, isSpiky, 0.0, 1 });
      if (size >= 512)
      {
        Register({ size, isSpiky, 0.0, 2 });
      }
      if (size <= 1024)
      {
        Register({ size, isSpiky, 1.0, 1 });
      }
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
