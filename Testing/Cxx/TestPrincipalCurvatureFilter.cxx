// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A cylinder has strength 1 along its axis, a sphere and a plane 0, a torus-like ellipsoid something
// between; in world axes, on a turned grid of unequal spacing.

#include "AnisotropyTesting.h"
#include "FilterTesting.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

namespace
{
struct Means
{
  double Strength;
  double Angle; // of the major direction from the axis, degrees
};

Means MeansOf(const testing::Field& field, const glm::dvec3& axis, double least, double largest)
{
  testing::Geometry geometry;
  geometry.Extent = { -20, 20, -20, 20, -14, 14 };
  geometry.Spacing = glm::dvec3(1.0, 1.0, 1.5);
  geometry.Direction = testing::Rotation();
  const auto image = testing::MakeImage(geometry, field, VTK_DOUBLE);
  vtkNew<vtkSobelNormalFilter> normals;
  normals->SetInputData(image);
  normals->SetSmoothing(1.0);
  normals->Update();
  vtkNew<vtkPrincipalCurvatureFilter> curvature;
  curvature->SetInputData(image);
  curvature->Update();
  Means means = { 0.0, 0.0 };
  int count = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    image->GetPoint(i, &point.x);
    if (glm::length(point) < 12.0 && field(point) > least && field(point) < largest)
    {
      const auto frame = testing::FrameAt(curvature->GetOutput(), normals->GetOutput(), i);
      means.Strength += testing::Strength(frame);
      means.Angle += testing::LineAngle(frame.major, axis);
      ++count;
    }
  }
  return { means.Strength / count, means.Angle / count };
}
}

int TestPrincipalCurvatureFilter(int, char*[])
{
  testing::Report report;
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.5, -0.2, 0.8));
  auto across = [&](const glm::dvec3& p) { return p - glm::dot(p, axis) * axis; };
  const Means cylinder =
    MeansOf([&](const glm::dvec3& p) { return glm::length(across(p)); }, axis, 5.0, 10.0);
  report.CheckAtLeast(cylinder.Strength, 0.95, "cylinder: strength");
  report.CheckAtMost(cylinder.Angle, 1.0, "cylinder: angle from the axis, degrees");
  const Means hollow =
    MeansOf([&](const glm::dvec3& p) { return -glm::length(across(p)); }, axis, -10.0, -5.0);
  report.CheckAtLeast(hollow.Strength, 0.95, "hollow cylinder: strength");
  report.CheckAtMost(hollow.Angle, 1.0, "hollow cylinder: angle from the axis, degrees");
  const Means sphere = MeansOf([](const glm::dvec3& p) { return glm::length(p); }, axis, 6.0, 11.0);
  report.CheckAtMost(sphere.Strength, 0.05, "sphere: strength");
  const Means plane = MeansOf([&](const glm::dvec3& p) { return glm::dot(p, axis); }, axis, -8.0, 8.0);
  report.CheckAtMost(plane.Strength, 1.0e-3, "plane: strength");
  const Means ellipsoid = MeansOf(
    [&](const glm::dvec3& p) {
      const glm::dvec3 q = across(p);
      return std::sqrt(glm::dot(q, q) + 0.1 * glm::dot(p, axis) * glm::dot(p, axis));
    },
    axis, 5.0, 8.0);
  report.CheckAtLeast(ellipsoid.Strength, 0.5, "prolate ellipsoid: strength");
  report.CheckAtMost(ellipsoid.Strength, 0.95, "prolate ellipsoid: strength");
  return report.ExitCode();
}
