// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Inside an image of equal spacing the filter points where vtkImageSobel3D points (whose smoothing
// is a little wider: weights 0.586, 0.343 for 1/2, 1/4), and is at least as close to the truth.

#include "FilterTesting.h"
#include "vtkImageSobel3D.h"
#include "vtkSobelNormalFilter.h"

namespace
{
double Scalar(const glm::dvec3& p)
{
  return std::sin(p.x) * std::cos(2.0 * p.y) + 0.1 * p.z * p.z + p.z;
}

glm::dvec3 Gradient(const glm::dvec3& p)
{
  return { std::cos(p.x) * std::cos(2.0 * p.y), -2.0 * std::sin(p.x) * std::sin(2.0 * p.y), 0.2 * p.z + 1.0 };
}
}

int TestSobelNormalFilterAgainstVTK(int, char*[])
{
  testing::Geometry geometry;
  geometry.Spacing = glm::dvec3(0.25);
  const auto image = testing::MakeImage(geometry, Scalar, VTK_DOUBLE);
  vtkNew<vtkSobelNormalFilter> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkNew<vtkImageSobel3D> sobel;
  sobel->SetInputData(image);
  sobel->Update();
  vtkDataArray* normals = filter->GetOutput()->GetPointData()->GetArray("Normals");
  vtkDataArray* gradients = sobel->GetOutput()->GetPointData()->GetScalars();
  double difference = 0.0;
  double ourError = 0.0;
  double theirError = 0.0;
  for (int z = 1; z < 31; ++z)
  {
    for (int y = 1; y < 31; ++y)
    {
      for (int x = 1; x < 31; ++x)
      {
        const vtkIdType i = x + 32 * (y + 32 * z);
        glm::dvec3 point;
        image->GetPoint(i, &point.x);
        const glm::dvec3 truth = -glm::normalize(Gradient(point));
        const glm::dvec3 ours = testing::VectorAt(normals, i);
        const glm::dvec3 theirs = -glm::normalize(testing::VectorAt(gradients, i));
        difference = std::max(difference, glm::length(ours - theirs));
        ourError = std::max(ourError, glm::length(ours - truth));
        theirError = std::max(theirError, glm::length(theirs - truth));
      }
    }
  }
  testing::Report report;
  report.CheckAtMost(difference, 0.02, "largest difference of the normal from vtkImageSobel3D's");
  report.CheckAtMost(ourError, theirError, "largest error of the normal, against theirs");
  return report.ExitCode();
}
