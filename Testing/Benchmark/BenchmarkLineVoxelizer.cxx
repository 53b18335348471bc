// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Segments per second of vtkAnisotropicLineVoxelizer on spirals: projections, lights, orders, grids.
// Processor time of all threads, so that other programs on the machine count little: two cores do twice
// what "segments/s" tells, as far as the parts that run on one thread allow (real time tells).
// The figures to compare: Analytic and Sampled512 with the same light, grid and order.

#include "vtkAnalyticLineSource.h"
#include "vtkAnisotropicLineVoxelizer.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace
{
struct Case
{
  vtkIdType Segments;
  int Grid = 256;
  int Order = 4;
  int Directions = 0; // of Sampled; 0: Analytic
  bool InWorld = false;
  int Threads = 2;
};

vtkPolyData* LinesOf(vtkIdType segments)
{
  static std::map<vtkIdType, vtkSmartPointer<vtkPolyData>> all;
  auto& lines = all[segments];
  if (!lines)
  {
    vtkNew<vtkAnalyticLineSource> source;
    source->SetNumberOfSegments(segments);
    source->Update();
    lines = source->GetOutput();
  }
  return lines;
}

void RunCase(benchmark::State& state, Case c)
{
  vtkSMPTools::Initialize(c.Threads);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputData(LinesOf(c.Segments));
  voxelizer->SetSampleDimensions(c.Grid, c.Grid, c.Grid);
  voxelizer->SetMaximumOrder(c.Order);
  vtkNew<vtkLightCollection> lights;
  vtkNew<vtkLight> light;
  light->SetPosition(1.0, 2.0, 3.0);
  lights->AddItem(light);
  voxelizer->SetLights(c.InWorld ? lights.Get() : nullptr);
  if (c.Directions > 0)
  {
    voxelizer->SetProjectionToSampled();
    voxelizer->SetNumberOfDirections(c.Directions);
  }
  for (auto _ : state)
  {
    voxelizer->Modified();
    voxelizer->Update();
  }
  state.counters["segments/s"] =
    benchmark::Counter(static_cast<double>(c.Segments), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["MiB"] = voxelizer->GetOutput()->GetActualMemorySize() / 1024.0;
}

void Register(const std::string& name, const Case& c)
{
  benchmark::RegisterBenchmark(name.c_str(), RunCase, c)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
}
}

int main(int argc, char* argv[])
{
  Register("Headlight/Analytic/256/order4/1M/2threads", { 1000000 });
  Register("Headlight/Analytic/256/order4/1M/1thread", { 1000000, 256, 4, 0, false, 1 });
  Register("Headlight/Analytic/256/order4/10M/2threads", { 10000000 });
  Register("Headlight/Analytic/256/order4/20k", { 20000 });
  Register("Headlight/Sampled128/256/order4/20k", { 20000, 256, 4, 128 });
  Register("Headlight/Sampled512/256/order4/20k", { 20000, 256, 4, 512 });
  Register("World/Analytic/256/order4/1M/2threads", { 1000000, 256, 4, 0, true });
  Register("World/Analytic/256/order4/10M/2threads", { 10000000, 256, 4, 0, true });
  for (int order : { 0, 2, 8, 12 })
  {
    Register("Headlight/Analytic/128/order" + std::to_string(order) + "/1M", { 1000000, 128, order });
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
