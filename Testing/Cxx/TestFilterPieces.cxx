// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Eight pieces are bit for bit the whole, and a piece requests no more than it needs: for every
// sampling pattern, interpolation, filter, smoothing and resolution, on a turned grid of unequal
// spacing, with missing values.

#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkFloatingPointExceptions.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include <algorithm>

namespace
{
// Voxels of the input that a piece may request beyond its own place, along each axis.
using Reach = std::function<int(int axis)>;

void CheckRequest(const std::array<int, 6>& request, const std::array<int, 6>& piece, double factor,
  const Reach& reach, const int whole[6], const std::string& name, testing::Report& report)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = static_cast<int>(std::floor(piece[2 * axis] / factor)) - reach(axis);
    const int last = static_cast<int>(std::ceil(piece[2 * axis + 1] / factor)) + reach(axis);
    const bool isWithin = request[2 * axis] >= std::max(first, whole[2 * axis]) &&
      request[2 * axis + 1] <= std::min(last, whole[2 * axis + 1]);
    report.Check(isWithin,
      name + ": axis " + std::to_string(axis) + " requests " + std::to_string(request[2 * axis]) + " to " +
        std::to_string(request[2 * axis + 1]) + " for " + std::to_string(piece[2 * axis]) + " to " +
        std::to_string(piece[2 * axis + 1]));
  }
}

void CheckPieces(vtkOpticsImageFilter* filter, const char* array, vtkImageData* image, const Reach& reach,
  const std::string& name, testing::Report& report)
{
  vtkNew<testing::RecordingSource> source;
  source->SetImage(image);
  filter->SetInputConnection(source->GetOutputPort());
  filter->UpdateWholeExtent();
  vtkNew<vtkImageData> whole;
  whole->ShallowCopy(filter->GetOutput());
  long long different = 0;
  for (const auto& octant : testing::Octants(whole->GetExtent()))
  {
    source->Requests.clear();
    source->Modified();
    filter->UpdateExtent(octant.data());
    different += testing::CountDifferent(whole, filter->GetOutput(), array);
    report.Check(std::equal(octant.begin(), octant.end(), filter->GetOutput()->GetExtent()),
      name + ": the piece has another extent");
    report.Check(source->Requests.size() == 1, name + ": more than one request");
    CheckRequest(source->Requests.front(), octant, filter->GetResolutionFactor(), reach, image->GetExtent(),
      name, report);
  }
  report.CheckAtMost(different, 0, name + ": voxels of pieces that differ from the whole");
}

struct Setting
{
  std::string Name;
  int Pattern;
  int Interpolation;
  double Filter;
  double Factor;
  double Smoothing;
  int Storage;
};
}

int TestFilterPieces(int, char*[])
{
  vtkFloatingPointExceptions::Disable(); // comparisons with NaN are meant
  testing::Geometry geometry;
  geometry.Extent = { -5, 30, 3, 33, -7, 21 };
  geometry.Spacing = glm::dvec3(1.0, 1.3, 2.1);
  geometry.Direction = testing::Rotation();
  const auto image = testing::MakeImage(geometry, [](const glm::dvec3& p) {
    const double value = std::sin(0.3 * p.x) + std::cos(0.2 * p.y + 0.25 * p.z) + 0.2 * testing::Noise(p);
    return testing::Noise(p, 1.0) < 0.002 ? std::nan("") : value;
  });
  // Radius, filter and smoothing of 4, 3 (1 x 3) and 3 (1 x 3) finest voxels; 1 for the stencil or the
  // neighbours of missing voxels, one more at a coarser resolution.
  auto reachOf = [&](double radius, double filter, double smoothing, int stencil, double factor) {
    return [=](int axis) {
      const double voxel = geometry.Spacing[axis] / factor;
      const double voxels = std::ceil(radius / voxel) + std::ceil(3.0 * filter / voxel) +
        std::ceil(3.0 * smoothing / voxel) + stencil;
      return static_cast<int>(std::ceil(voxels / factor));
    };
  };
  testing::Report report;
  for (const double factor : { 1.0, 0.75, 0.5 })
  {
    vtkNew<vtkSobelNormalFilter> sobel;
    sobel->SetResolutionFactor(factor);
    CheckPieces(sobel, "Normals", image, reachOf(0, 0, 0, 1, factor), "Sobel", report);
    CheckPieces(sobel, "GradientMagnitude", image, reachOf(0, 0, 0, 1, factor), "Sobel", report);
    sobel->SetSmoothing(1.0);
    CheckPieces(sobel, "Normals", image, reachOf(0, 0, 1, 1, factor), "Smooth Sobel", report);
    vtkNew<vtkPrincipalCurvatureFilter> curvature;
    curvature->SetResolutionFactor(factor);
    CheckPieces(curvature, "AmbientCovariance", image, reachOf(0, 0, 1, 2, factor), "Curvature", report);
  }
  using Filter = vtkAmbientCovarianceFilter;
  const Setting settings[] = {
    { "Shared nearest", Filter::Shared, Filter::Nearest, 0.0, 1.0, 0.0, Filter::Map },
    { "Shared linear", Filter::Shared, Filter::Linear, 0.0, 1.0, 0.0, Filter::World },
    { "Shared filtered", Filter::Shared, Filter::Nearest, 1.0, 1.0, 0.0, Filter::Map },
    { "Shared at 1/2", Filter::Shared, Filter::Linear, 1.0, 0.5, 0.0, Filter::Map },
    { "PerBlock nearest", Filter::PerBlock, Filter::Nearest, 0.0, 1.0, 1.0, Filter::Components },
    { "PerBlock linear at 3/4", Filter::PerBlock, Filter::Linear, 0.0, 0.75, 1.0, Filter::Map },
    { "PerVoxel nearest", Filter::PerVoxel, Filter::Nearest, 0.0, 1.0, 0.0, Filter::Map },
    { "PerVoxel linear", Filter::PerVoxel, Filter::Linear, 1.0, 0.75, 0.0, Filter::World },
    { "Exhaustive", Filter::Exhaustive, Filter::Nearest, 0.0, 1.0, 0.0, Filter::Map },
  };
  for (const Setting& setting : settings)
  {
    vtkNew<Filter> filter;
    filter->SetScalarRange(-2.0, 2.0);
    filter->SetRadius(4.0);
    filter->SetNumberOfSamples(40);
    filter->SetSamplingPattern(setting.Pattern);
    filter->SetSampleInterpolation(setting.Interpolation);
    filter->SetFilterStandardDeviation(setting.Filter);
    filter->SetResolutionFactor(setting.Factor);
    filter->SetSmoothing(setting.Smoothing);
    filter->SetStorage(setting.Storage);
    CheckPieces(filter, "AmbientCovariance", image,
      reachOf(4.0, setting.Filter, setting.Smoothing, 1, setting.Factor), setting.Name, report);
  }
  return report.ExitCode();
}
