// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Seconds of vtkGradientAlignedHistogram on 256^3 shorts, by step length and threads, and of the first
// guess on its result. Medians: --benchmark_repetitions=5 --benchmark_report_aggregates_only=true.

#include "vtkGradientAlignedHistogram.h"
#include "vtkImageData.h"
#include "vtkLightingTransferFunction.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{
const int Size = 256;

// Shells with noise: every voxel has a gradient.
vtkImageData* Volume()
{
  static vtkSmartPointer<vtkImageData> image;
  if (!image)
  {
    image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(Size, Size, Size);
    image->AllocateScalars(VTK_SHORT, 1);
    auto* scalars = static_cast<short*>(image->GetScalarPointer());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double* point = image->GetPoint(i);
      const double radius = std::hypot(point[0] - 127.5, point[1] - 127.5, point[2] - 127.5);
      scalars[i] = static_cast<short>(1000.0 * std::sin(0.1 * radius) + i * 7919 % 37);
    }
  }
  return image;
}

void BM_Histogram(benchmark::State& state)
{
  vtkSMPTools::Initialize(static_cast<int>(state.range(1)));
  vtkNew<vtkGradientAlignedHistogram> filter;
  filter->SetInputData(Volume());
  filter->SetStepLength(static_cast<double>(state.range(0)));
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
}
BENCHMARK(BM_Histogram)
  ->ArgNames({ "step", "threads" })
  ->ArgsProduct({ { 1, 3 }, { 1, 2 } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

void BM_FirstGuess(benchmark::State& state)
{
  vtkNew<vtkGradientAlignedHistogram> filter;
  filter->SetInputData(Volume());
  filter->Update();
  vtkNew<vtkLightingTransferFunction> function;
  for (auto _ : state)
  {
    function->InitializeFromHistogram(filter->GetOutput(), 4);
  }
}
BENCHMARK(BM_FirstGuess)->Unit(benchmark::kMillisecond);
}

BENCHMARK_MAIN();
