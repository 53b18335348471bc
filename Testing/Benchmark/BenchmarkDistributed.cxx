// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What preprocessing takes on 1, 2, 4 ... processes: seconds, memory, messages.
//
//   mpirun -n 4 BenchmarkDistributed [--size 128] [--segments 1000000] [--grid 128] [--weak]
//
// With --weak the size is that of one process's share: the voxels (size^3) and segments grow with the
// number of processes. Each process has one thread, so that processes on the cores of one machine compare.
// Of each filter:
//   seconds    of the slowest process, in the filter alone, waiting for others included
//   processor  seconds of processor time in the process with the most; includes MPI's polling while it waits
//   memory     MiB that the process with the most holds at its peak, beyond what it held before: the piece
//              of the source, with ghost layers, what the filter works with, and its output
//   messages   KiB that the process with the most hands to MPI
//   ghosts     voxels of the source's piece over those of the filter's: what is computed more than once

#include "CountedMessages.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkAnalyticLineSource.h"
#include "vtkAnalyticVolumeSource.h"
#include "vtkAnisotropicLineVoxelizer.h"
#include "vtkGradientAlignedHistogram.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include "vtkCallbackCommand.h"
#include "vtkCommunicator.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <malloc.h>
#include <string>

namespace
{
struct Options
{
  int Size = 128;
  long long Segments = 1000000;
  int Grid = 128;
  bool IsWeak = false;
};

Options ReadOptions(int argc, char* argv[])
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    const long long value = i + 1 < argc ? std::atoll(argv[i + 1]) : 0;
    options.IsWeak = options.IsWeak || name == "--weak";
    options.Size = name == "--size" ? static_cast<int>(value) : options.Size;
    options.Segments = name == "--segments" ? value : options.Segments;
    options.Grid = name == "--grid" ? static_cast<int>(value) : options.Grid;
  }
  return options;
}

double WallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// MiB that this process holds ("VmRSS") or has held at most ("VmHWM").
double Memory(const std::string& which)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, which.size(), which) == 0)
    {
      return std::atof(line.c_str() + which.size() + 1) / 1024.0;
    }
  }
  return 0.0;
}

void ForgetPeak()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

// Seconds between a filter's start and end, which leave its source out.
class Stopwatch
{
public:
  explicit Stopwatch(vtkAlgorithm* filter)
  {
    this->Start->SetClientData(this);
    this->Start->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
      auto* watch = static_cast<Stopwatch*>(client);
      watch->Wall -= WallSeconds();
      watch->Processor -= ProcessorSeconds();
    });
    this->End->SetClientData(this);
    this->End->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
      auto* watch = static_cast<Stopwatch*>(client);
      watch->Wall += WallSeconds();
      watch->Processor += ProcessorSeconds();
    });
    filter->AddObserver(vtkCommand::StartEvent, this->Start);
    filter->AddObserver(vtkCommand::EndEvent, this->End);
  }
  double Wall = 0.0;
  double Processor = 0.0;

private:
  vtkNew<vtkCallbackCommand> Start, End;
};

class Benchmark
{
public:
  explicit Benchmark(vtkMPIController* controller)
    : Controller(controller)
  {
  }

  double Largest(double number) const
  {
    double largest = number;
    this->Controller->AllReduce(&number, &largest, 1, vtkCommunicator::MAX_OP);
    return largest;
  }

  void Measure(const char* name, vtkAlgorithm* filter, vtkAlgorithm* source)
  {
    this->Controller->Barrier();
    malloc_trim(0); // what is free does not hide what is taken
    const double before = Memory("VmRSS:");
    ForgetPeak();
    MessageBytes = 0;
    const Stopwatch watch(filter);
    filter->UpdatePiece(this->Controller->GetLocalProcessId(), this->Controller->GetNumberOfProcesses(), 0);
    const auto bytes = static_cast<double>(MessageBytes);
    const double memory = Memory("VmHWM:") - before;
    auto* piece = vtkImageData::SafeDownCast(source->GetOutputDataObject(0));
    auto* output = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
    const double ghosts = piece && output->GetNumberOfPoints() > 0
      ? static_cast<double>(piece->GetNumberOfPoints()) / output->GetNumberOfPoints()
      : 0.0;
    const double figures[] = { this->Largest(watch.Wall), this->Largest(watch.Processor),
      this->Largest(memory), this->Largest(bytes / 1024.0), this->Largest(ghosts) };
    if (this->Controller->GetLocalProcessId() == 0)
    {
      std::printf("%-12s %9.3f %9.3f %9.1f %10.1f %7.2f\n", name, figures[0], figures[1], figures[2],
        figures[3], figures[4]);
      std::fflush(stdout);
    }
    filter->GetOutputDataObject(0)->Initialize();
    source->GetOutputDataObject(0)->Initialize();
    source->Modified(); // not there any more
  }

private:
  vtkMPIController* Controller;
};

void MeasureVolume(Benchmark& benchmark, int size)
{
  vtkNew<vtkAnalyticVolumeSource> source;
  source->SetFieldToVortexTubes();
  source->SetDimensions(size, size, size);
  vtkNew<vtkSobelNormalFilter> sobel;
  vtkNew<vtkPrincipalCurvatureFilter> curvature;
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  vtkNew<vtkGradientAlignedHistogram> histogram;
  const std::pair<const char*, vtkImageAlgorithm*> filters[] = { { "normals", sobel },
    { "curvature", curvature }, { "covariance", covariance } };
  for (const auto& [name, filter] : filters)
  {
    filter->SetInputConnection(source->GetOutputPort());
    benchmark.Measure(name, filter, source);
  }
  histogram->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkAnalyticVolumeSource> none; // bins are no voxels
  benchmark.Measure("histogram", histogram, none);
}

void MeasureLines(Benchmark& benchmark, long long segments, int grid)
{
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(segments);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(source->GetOutputPort());
  voxelizer->SetSampleDimensions(grid, grid, grid);
  benchmark.Measure("lines", voxelizer, source);
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  vtkSMPTools::Initialize(1);
  const Options options = ReadOptions(argc, argv);
  const int processes = controller->GetNumberOfProcesses();
  const int share = options.IsWeak ? processes : 1;
  const int size = static_cast<int>(std::lround(options.Size * std::cbrt(share)));
  if (controller->GetLocalProcessId() == 0)
  {
    std::printf("%d processes, %d^3 voxels, %lld segments in %d^3 voxels\n", processes, size,
      options.Segments * share, options.Grid);
    std::printf("%-12s %9s %9s %9s %10s %7s\n", "", "seconds", "processor", "memory", "messages", "ghosts");
  }
  Benchmark benchmark(controller);
  MeasureVolume(benchmark, size);
  MeasureLines(benchmark, options.Segments * share, options.Grid);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return 0;
}
