// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Around an oblique cylinder the major direction is its axis, for every sampling pattern.

#include "AnisotropyTesting.h"
#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkSobelNormalFilter.h"

namespace
{
const glm::dvec3 Axis = glm::normalize(glm::dvec3(0.4, 0.3, 0.85));

double DistanceFromAxis(const glm::dvec3& point)
{
  return glm::length(point - glm::dot(point, Axis) * Axis);
}

void CheckPattern(vtkImageData* image, vtkImageData* normals, int pattern, int interpolation,
  double largestMeanAngle, testing::Report& report)
{
  vtkNew<vtkAmbientCovarianceFilter> filter;
  filter->SetInputData(image);
  filter->SetSamplingPattern(pattern);
  filter->SetSampleInterpolation(interpolation);
  filter->SetRadius(8.0);
  filter->SetScalarRange(0.0, 10.0);
  filter->Update();
  double sum = 0.0;
  double strength = 0.0;
  long long count = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    image->GetPoint(i, &point.x);
    const double distance = DistanceFromAxis(point);
    if (glm::length(point) < 8.0 && distance > 1.5 && distance < 3.0)
    {
      const auto frame = testing::FrameAt(filter->GetOutput(), normals, i);
      sum += testing::LineAngle(frame.major, Axis);
      strength += testing::Strength(frame);
      ++count;
    }
  }
  const std::string name =
    std::string(filter->GetSamplingPatternAsString()) + " " + filter->GetSampleInterpolationAsString();
  report.Check(count > 200, "enough voxels: " + std::to_string(count));
  report.CheckAtMost(sum / count, largestMeanAngle, name + ": mean angle from the axis, degrees");
  report.CheckAtLeast(strength / count, 0.4, name + ": mean strength");
}
}

int TestAmbientCovarianceFilterCylinder(int, char*[])
{
  testing::Geometry geometry;
  geometry.Extent = { -20, 20, -20, 20, -20, 20 };
  const auto image = testing::MakeImage(geometry, DistanceFromAxis);
  vtkNew<vtkSobelNormalFilter> sobel;
  sobel->SetInputData(image);
  sobel->Update();
  testing::Report report;
  using Filter = vtkAmbientCovarianceFilter;
  CheckPattern(image, sobel->GetOutput(), Filter::Exhaustive, Filter::Nearest, 1.0, report);
  CheckPattern(image, sobel->GetOutput(), Filter::Shared, Filter::Nearest, 12.0, report);
  CheckPattern(image, sobel->GetOutput(), Filter::Shared, Filter::Linear, 12.0, report);
  CheckPattern(image, sobel->GetOutput(), Filter::PerBlock, Filter::Nearest, 12.0, report);
  CheckPattern(image, sobel->GetOutput(), Filter::PerVoxel, Filter::Nearest, 12.0, report);
  CheckPattern(image, sobel->GetOutput(), Filter::PerVoxel, Filter::Linear, 12.0, report);
  return report.ExitCode();
}
