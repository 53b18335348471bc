// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A linear ramp has its exact gradient at every voxel, borders included, in world axes, whatever the
// spacing, the direction matrix and the resolution.

#include "FilterTesting.h"
#include "vtkSobelNormalFilter.h"

namespace
{
void CheckRamp(const testing::Geometry& geometry, double factor, testing::Report& report)
{
  const glm::dvec3 gradient(0.7, -1.3, 0.4);
  const auto image = testing::MakeImage(
    geometry, [&](const glm::dvec3& p) { return 5.0 + glm::dot(gradient, p); }, VTK_DOUBLE);
  vtkNew<vtkSobelNormalFilter> filter;
  filter->SetInputData(image);
  filter->SetResolutionFactor(factor);
  filter->Update();
  vtkImageData* output = filter->GetOutput();
  vtkDataArray* normals = output->GetPointData()->GetArray("Normals");
  vtkDataArray* magnitudes = output->GetPointData()->GetArray("GradientMagnitude");
  double worstNormal = 0.0;
  double worstMagnitude = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double length = glm::length(gradient);
    worstNormal = std::max(worstNormal, glm::length(testing::VectorAt(normals, i) + gradient / length));
    worstMagnitude = std::max(worstMagnitude, std::abs(magnitudes->GetComponent(i, 0) / length - 1.0));
  }
  report.Check(output->GetNumberOfPoints() > 100, "the output has voxels");
  report.CheckAtMost(worstNormal, 1.0e-6, "largest error of a normal");
  report.CheckAtMost(worstMagnitude, 1.0e-6, "largest relative error of a magnitude");
}
}

int TestSobelNormalFilterRamps(int, char*[])
{
  testing::Report report;
  testing::Geometry geometry;
  geometry.Extent = { -3, 17, 2, 20, 5, 19 };
  CheckRamp(geometry, 1.0, report);
  geometry.Spacing = glm::dvec3(0.5, 2.0, 0.1);
  geometry.Direction = testing::Rotation();
  geometry.Origin = glm::dvec3(-1.0, 3.0, 8.0);
  CheckRamp(geometry, 1.0, report);
  CheckRamp(geometry, 0.75, report);
  geometry.Spacing = glm::dvec3(1.0, 100.0, -1.0);
  CheckRamp(geometry, 1.0, report);
  return report.ExitCode();
}
