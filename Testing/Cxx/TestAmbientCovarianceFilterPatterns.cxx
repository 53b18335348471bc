// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Angle and strength of each sampling pattern against all voxels of the ball: more samples are
// closer, the evenly spread patterns at least as close as random points, a Gaussian filter, 8 bits
// and a coarser grid cost little.

#include "AnisotropyTesting.h"
#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkSobelNormalFilter.h"

namespace
{
struct Errors
{
  double Angle = 0.0;    // degrees, weighted by the true strength
  double Strength = 0.0; // mean absolute
};

Errors ErrorsAgainst(vtkImageData* truth, vtkImageData* found, vtkImageData* normals)
{
  Errors errors;
  double weights = 0.0;
  long long count = 0;
  for (vtkIdType i = 0; i < truth->GetNumberOfPoints(); ++i)
  {
    const auto wanted = testing::FrameAt(truth, normals, i);
    const auto frame = testing::FrameAt(found, normals, i);
    const double weight = testing::Strength(wanted);
    errors.Angle += weight * testing::LineAngle(wanted.major, frame.major);
    errors.Strength += std::abs(weight - testing::Strength(frame));
    weights += weight;
    ++count;
  }
  return { errors.Angle / weights, errors.Strength / count };
}
}

int TestAmbientCovarianceFilterPatterns(int, char*[])
{
  testing::Report report;
  testing::Geometry geometry;
  geometry.Extent = { 0, 39, 0, 39, 0, 39 };
  const auto image = testing::MakeImage(geometry, [](const glm::dvec3& p) {
    return std::sin(0.35 * p.x + 0.1 * p.z) + std::cos(0.3 * p.y) * std::sin(0.15 * p.z);
  });
  vtkNew<vtkSobelNormalFilter> normals;
  normals->SetInputData(image);
  normals->Update();
  using Filter = vtkAmbientCovarianceFilter;
  vtkNew<Filter> truth;
  truth->SetInputData(image);
  truth->SetRadius(6.0);
  truth->SetSamplingPatternToExhaustive();
  truth->Update();
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  filter->SetRadius(6.0);
  auto measure = [&](const std::string& name) {
    filter->Update();
    const Errors errors = ErrorsAgainst(truth->GetOutput(), filter->GetOutput(), normals->GetOutput());
    std::cout << name << ": angle " << errors.Angle << " degrees, strength " << errors.Strength << "\n";
    return errors;
  };
  Errors last = { 90.0, 1.0 };
  for (const int number : { 30, 100, 300 })
  {
    filter->SetNumberOfSamples(number);
    Errors errors[3];
    for (int pattern = Filter::Shared; pattern <= Filter::PerVoxel; ++pattern)
    {
      filter->SetSamplingPattern(pattern);
      errors[pattern] =
        measure(std::string(filter->GetSamplingPatternAsString()) + " " + std::to_string(number));
    }
    report.CheckAtMost(errors[0].Angle, 1.15 * errors[2].Angle, "Shared against PerVoxel, angle");
    report.CheckAtMost(errors[1].Angle, 1.15 * errors[2].Angle, "PerBlock against PerVoxel, angle");
    report.CheckAtMost(errors[0].Angle, last.Angle, "angle with more samples");
    report.CheckAtMost(errors[0].Strength, last.Strength, "strength with more samples");
    last = errors[0];
  }
  filter->SetSamplingPatternToShared();
  filter->SetNumberOfSamples(100);
  const Errors plain = measure("Shared 100 again");
  filter->NoiseCorrectionOn();
  measure("with noise correction");
  filter->NoiseCorrectionOff();
  filter->SetOutputPrecisionTo8Bits();
  const Errors rounded = measure("in 8 bits");
  report.CheckAtMost(rounded.Angle, plain.Angle + 0.2, "angle in 8 bits");
  filter->SetOutputPrecisionTo32Bits();
  filter->SetFilterStandardDeviation(1.0);
  const Errors filtered = measure("filtered by 1 voxel");
  report.CheckAtMost(filtered.Angle, plain.Angle, "angle of the filtered covariance");
  return report.ExitCode();
}
