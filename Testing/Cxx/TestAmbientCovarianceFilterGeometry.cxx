// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The result belongs to the world: a turned grid turns it, a scaled world leaves it, the ball of a
// grid of unequal spacing is round, given normals equal the filter's own, points that another
// process owns count and blanked ones don't.

#include "AnisotropyTesting.h"
#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatingPointExceptions.h"
#include "vtkSobelNormalFilter.h"
#include "vtkUnsignedCharArray.h"

namespace
{
struct Result
{
  vtkNew<vtkSobelNormalFilter> Normals;
  vtkNew<vtkAmbientCovarianceFilter> Covariance;
};

void Compute(Result& result, vtkImageData* image, double radius, double factor = 1.0)
{
  result.Normals->SetInputData(image);
  result.Normals->SetResolutionFactor(factor);
  result.Normals->Update();
  result.Covariance->SetInputData(image);
  result.Covariance->SetRadius(radius);
  result.Covariance->SetSamplingPatternToExhaustive();
  result.Covariance->SetResolutionFactor(factor);
  result.Covariance->Update();
}

optics::AnisotropyFrame Frame(Result& result, vtkIdType i)
{
  return testing::FrameAt(result.Covariance->GetOutput(), result.Normals->GetOutput(), i);
}

void CheckTurnedAndScaled(testing::Report& report)
{
  auto field = [](const glm::dvec3& p) { return std::sin(0.3 * p.x + 0.1 * p.y) + std::cos(0.25 * p.z); };
  testing::Geometry plain;
  testing::Geometry turned;
  turned.Direction = testing::Rotation();
  turned.Spacing = glm::dvec3(1.0e-4);
  const auto back = [&](const glm::dvec3& p) { return glm::transpose(turned.Direction) * p / 1.0e-4; };
  Result first;
  Result second;
  Compute(first, testing::MakeImage(plain, field, VTK_DOUBLE), 5.0);
  Compute(second,
    testing::MakeImage(
      turned, [&](const glm::dvec3& p) { return field(back(p)); }, VTK_DOUBLE),
    5.0);
  double angle = 0.0;
  double strength = 0.0;
  for (vtkIdType i = 0; i < 32 * 32 * 32; ++i)
  {
    const auto a = Frame(first, i);
    const auto b = Frame(second, i);
    strength = std::max(strength, std::abs(testing::Strength(a) - testing::Strength(b)));
    if (testing::Strength(a) > 0.1)
    {
      angle += testing::LineAngle(turned.Direction * a.major, b.major) / (32 * 32 * 32);
    }
  }
  report.CheckAtMost(angle, 0.05, "turned and scaled: mean angle, degrees");
  report.CheckAtMost(strength, 0.05, "turned and scaled: largest difference of strength");
}

// Around a thin plate a round ball cuts a disk: no anisotropy, whatever the spacing.
void CheckRoundBall(testing::Report& report)
{
  testing::Geometry geometry;
  geometry.Extent = { 0, 47, 0, 23, 0, 47 };
  geometry.Spacing = glm::dvec3(1.0, 2.0, 1.0);
  Result result;
  Compute(result, testing::MakeImage(geometry, [](const glm::dvec3& p) { return p.z; }), 8.0);
  report.CheckAtMost(testing::Strength(Frame(result, 24 + 48 * (12 + 24 * 24))), 0.03, "strength on a plate");
}

void CheckGivenNormals(testing::Report& report)
{
  const auto image =
    testing::MakeImage({}, [](const glm::dvec3& p) { return std::sin(0.3 * p.x) * p.y + p.z; });
  vtkNew<vtkSobelNormalFilter> normals;
  normals->SetInputData(image);
  vtkNew<vtkAmbientCovarianceFilter> own;
  own->SetInputData(image);
  own->Update();
  vtkNew<vtkAmbientCovarianceFilter> given;
  given->SetInputData(image);
  given->SetNormalsConnection(normals->GetOutputPort());
  given->Update();
  double worst = 0.0;
  vtkDataArray* a = own->GetOutput()->GetPointData()->GetArray("AmbientCovariance");
  vtkDataArray* b = given->GetOutput()->GetPointData()->GetArray("AmbientCovariance");
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    worst = std::max(worst, glm::length(testing::VectorAt(a, i) - testing::VectorAt(b, i)));
  }
  report.CheckAtMost(worst, 1.0e-3, "given normals: largest difference");
}

void CheckGhosts(testing::Report& report)
{
  auto field = [](const glm::dvec3& p) { return std::sin(0.3 * p.x) * p.y + p.z; };
  const auto plain = testing::MakeImage({}, field);
  const auto marked =
    testing::MakeImage({}, [&](const glm::dvec3& p) { return p.x == 9.0 ? 1.0e6 : field(p); });
  const auto missing =
    testing::MakeImage({}, [&](const glm::dvec3& p) { return p.x == 9.0 ? std::nan("") : field(p); });
  plain->AllocatePointGhostArray();
  marked->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
  {
    plain->GetPointGhostArray()->SetValue(i, vtkDataSetAttributes::DUPLICATEPOINT);
    marked->GetPointGhostArray()->SetValue(i, i % 32 == 9 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  Result duplicate;
  Result unmarked;
  Result hidden;
  Result nan;
  Compute(duplicate, plain, 4.0);
  Compute(unmarked, testing::MakeImage({}, field), 4.0);
  Compute(hidden, marked, 4.0);
  Compute(nan, missing, 4.0);
  const char* name = "AmbientCovariance";
  report.CheckAtMost(
    testing::CountDifferent(unmarked.Covariance->GetOutput(), duplicate.Covariance->GetOutput(), name), 0,
    "voxels changed by DUPLICATEPOINT");
  report.CheckAtMost(
    testing::CountDifferent(nan.Covariance->GetOutput(), hidden.Covariance->GetOutput(), name), 0,
    "voxels where HIDDENPOINT differs from NaN");
}

// Half the resolution, the same world radius: nearly the same frames.
void CheckResolution(testing::Report& report)
{
  testing::Geometry geometry;
  geometry.Extent = { 0, 62, 0, 62, 0, 62 };
  const auto image = testing::MakeImage(
    geometry, [](const glm::dvec3& p) { return std::sin(0.15 * p.x + 0.05 * p.y) + std::cos(0.12 * p.z); });
  Result fine;
  Result coarse;
  Compute(fine, image, 10.0);
  Compute(coarse, image, 10.0, 0.5);
  int size[3];
  coarse.Covariance->GetOutput()->GetDimensions(size);
  report.Check(size[0] == 32 && size[1] == 32 && size[2] == 32, "half the resolution has 32 voxels of 63");
  double angle = 0.0;
  int count = 0;
  for (vtkIdType i = 0; i < 32 * 32 * 32; ++i)
  {
    const vtkIdType j = 2 * (i % 32) + 63 * (2 * (i / 32 % 32) + 63 * (2 * (i / 1024)));
    const auto a = Frame(fine, j);
    if (testing::Strength(a) > 0.2)
    {
      angle += testing::LineAngle(a.major, Frame(coarse, i).major);
      ++count;
    }
  }
  report.CheckAtMost(angle / count, 6.0, "half the resolution: mean angle, degrees");
}
}

int TestAmbientCovarianceFilterGeometry(int, char*[])
{
  vtkFloatingPointExceptions::Disable(); // comparisons with NaN are meant
  testing::Report report;
  CheckTurnedAndScaled(report);
  CheckRoundBall(report);
  CheckGivenNormals(report);
  CheckGhosts(report);
  CheckResolution(report);
  return report.ExitCode();
}
