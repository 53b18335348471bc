// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Samples per second of vtkAmbientCovarianceFilter: sampling patterns, interpolation, instruction
// sets, threads. The whole filter is timed, normals given; the volume is noise, so that every
// voxel has a normal. Medians: --benchmark_repetitions=5 --benchmark_report_aggregates_only=true.

#include "vtkAmbientCovarianceFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkSobelNormalFilter.h"

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <cstdint>
#include <map>
#include <string>

namespace
{
vtkSmartPointer<vtkImageData> Volume(int size, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->AllocateScalars(type, 1);
  std::uint32_t state = 1;
  auto fill = [&](auto* scalars) {
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      state = state * 1664525u + 1013904223u;
      scalars[i] = state >> 24;
    }
  };
  type == VTK_SHORT ? fill(static_cast<short*>(image->GetScalarPointer()))
                    : fill(static_cast<unsigned char*>(image->GetScalarPointer()));
  return image;
}

struct Inputs
{
  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkSobelNormalFilter> Normals;
};

// Kept from one benchmark to the next.
Inputs& InputsOf(int size, int type)
{
  static std::map<std::pair<int, int>, Inputs> all;
  Inputs& inputs = all[{ size, type }];
  if (!inputs.Image)
  {
    inputs.Image = Volume(size, type);
    inputs.Normals->SetInputData(inputs.Image);
    inputs.Normals->Update();
  }
  return inputs;
}

struct Case
{
  int Pattern;
  int Interpolation;
  int Size;
  int Type;
  int Threads;
  int64_t Targets; // 0: the best
};

void RunCase(benchmark::State& state, Case c)
{
  Inputs& inputs = InputsOf(c.Size, c.Type);
  hwy::SetSupportedTargetsForTest(c.Targets);
  vtkSMPTools::Initialize(c.Threads);
  vtkNew<vtkAmbientCovarianceFilter> filter;
  filter->SetInputData(inputs.Image);
  filter->SetNormalsConnection(inputs.Normals->GetOutputPort());
  filter->SetSamplingPattern(c.Pattern);
  filter->SetSampleInterpolation(c.Interpolation);
  filter->SetScalarRange(0.0, 255.0);
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  const bool isExhaustive = c.Pattern == vtkAmbientCovarianceFilter::Exhaustive;
  const double samples = isExhaustive ? 4169.0 : filter->GetNumberOfSamples();
  state.counters["samples/s"] = benchmark::Counter(
    samples * inputs.Image->GetNumberOfPoints(), benchmark::Counter::kIsIterationInvariantRate);
  hwy::SetSupportedTargetsForTest(0);
}

void Register(const std::string& name, const Case& c)
{
  benchmark::RegisterBenchmark(name.c_str(), RunCase, c)->Unit(benchmark::kMillisecond)->UseRealTime();
}

// Highway 1.0 has no target for SSE2: its portable one (EMU128), compiled for the baseline of x86-64,
// is what runs on such a machine.
const std::map<std::string, int64_t> InstructionSets = { { "SSE2", HWY_EMU128 }, { "SSE4", HWY_SSE4 },
  { "AVX2", HWY_AVX2 }, { "AVX512", HWY_AVX3 } };
}

int main(int argc, char* argv[])
{
  using Filter = vtkAmbientCovarianceFilter;
  const int64_t supported = hwy::SupportedTargets();
  Register("PerVoxel/Nearest/Literal/64/1thread", { Filter::PerVoxel, 0, 64, VTK_UNSIGNED_CHAR, 1, 0 });
  for (const auto& set : InstructionSets)
  {
    const bool isThere = (set.second & supported) != 0;
    for (int threads = 1; isThere && threads <= 2; ++threads)
    {
      const std::string end = "/" + set.first + "/256/" + std::to_string(threads) + "threads";
      const int64_t targets = set.second;
      Register("Shared/Nearest/uint8" + end, { Filter::Shared, 0, 256, VTK_UNSIGNED_CHAR, threads, targets });
      Register("Shared/Nearest/int16" + end, { Filter::Shared, 0, 256, VTK_SHORT, threads, targets });
      Register("Shared/Linear/uint8" + end, { Filter::Shared, 1, 256, VTK_UNSIGNED_CHAR, threads, targets });
      Register(
        "PerBlock/Nearest/uint8" + end, { Filter::PerBlock, 0, 256, VTK_UNSIGNED_CHAR, threads, targets });
    }
  }
  Register("Exhaustive/Nearest/uint8/64/1thread", { Filter::Exhaustive, 0, 64, VTK_UNSIGNED_CHAR, 1, 0 });
  Register("PerVoxel/Linear/Literal/64/1thread", { Filter::PerVoxel, 1, 64, VTK_UNSIGNED_CHAR, 1, 0 });
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
