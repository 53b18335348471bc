// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics info: what a file holds, and what its tangent frames would cost.

#include "Commands.h"
#include "VolumeFile.h"

#include <vtkImageData.h>
#include <vtkImageHistogramStatistics.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>

#include <cstdio>
#include <memory>

namespace
{
void PrintGeometry(const Volume& volume)
{
  vtkImageData* image = volume.Image;
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  const double* direction = image->GetDirectionMatrix()->GetData();
  std::printf("file        %s\n", volume.Name.c_str());
  std::printf("dimensions  %d x %d x %d\n", dimensions[0], dimensions[1], dimensions[2]);
  std::printf("spacing     %g x %g x %g\n", spacing[0], spacing[1], spacing[2]);
  std::printf("origin      %g, %g, %g\n", origin[0], origin[1], origin[2]);
  std::printf("direction   %g %g %g / %g %g %g / %g %g %g\n", direction[0], direction[1], direction[2],
    direction[3], direction[4], direction[5], direction[6], direction[7], direction[8]);
}

void PrintScalars(vtkImageData* image)
{
  vtkNew<vtkImageHistogramStatistics> statistics;
  statistics->SetInputData(image);
  statistics->SetAutoRangePercentiles(1.0, 99.0);
  statistics->SetAutoRangeExpansionFactors(0.0, 0.0);
  statistics->Update();
  double percentiles[2];
  statistics->GetAutoRange(percentiles);
  std::printf("type        %s\n", image->GetScalarTypeAsString());
  std::printf("range       %g to %g\n", statistics->GetMinimum(), statistics->GetMaximum());
  std::printf("histogram   1 %%: %g, median: %g, 99 %%: %g, mean: %g, standard deviation: %g\n",
    percentiles[0], statistics->GetMedian(), percentiles[1], statistics->GetMean(),
    statistics->GetStandardDeviation());
}

// Normals N and ambient covariance C are three numbers a voxel each.
void PrintMemory(vtkImageData* image)
{
  const double voxels = static_cast<double>(image->GetNumberOfPoints());
  for (const int bits : { 8, 16, 32 })
  {
    const double mebibytes = 3.0 * voxels * bits / 8.0 / (1024.0 * 1024.0);
    std::printf("frames      %2d bits: N %.1f MiB + C %.1f MiB\n", bits, mebibytes, mebibytes);
  }
}
}

void AddInfoCommand(CLI::App& program)
{
  const auto file = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("info", "Print what a file holds");
  command->add_option("FILE", *file, "Volume")->required();
  command->callback([file] {
    const Volume volume = ReadVolume(*file);
    PrintGeometry(volume);
    PrintScalars(volume.Image);
    PrintMemory(volume.Image);
  });
}
