// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Thin and constant volumes, tiny and huge spacings and scalars, missing values: no crash, no NaN,
// no infinity, and vectors that are unit or zero.

#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatingPointExceptions.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
void CheckFinite(
  vtkOpticsImageFilter* filter, vtkImageData* image, const std::string& name, testing::Report& report)
{
  filter->SetInputData(image);
  filter->Update();
  vtkPointData* arrays = filter->GetOutput()->GetPointData();
  report.Check(arrays->GetNumberOfArrays() > 0, name + ": no output");
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const long long count = testing::CountNotFinite(arrays->GetArray(i));
    report.Check(count == 0,
      name + ", " + filter->GetClassName() + ": " + std::to_string(count) + " numbers of " +
        arrays->GetArray(i)->GetName() + " are not finite");
  }
}

void CheckImage(vtkImageData* image, const std::string& name, testing::Report& report)
{
  vtkNew<vtkSobelNormalFilter> sobel;
  vtkNew<vtkPrincipalCurvatureFilter> curvature;
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetRadius(3.0);
  covariance->SetNumberOfSamples(30);
  for (const double factor : { 1.0, 0.4 })
  {
    sobel->SetResolutionFactor(factor);
    curvature->SetResolutionFactor(factor);
    covariance->SetResolutionFactor(factor);
    CheckFinite(sobel, image, name, report);
    CheckFinite(curvature, image, name, report);
    for (int setting = 0; setting < 16; ++setting)
    {
      covariance->SetSamplingPattern(setting % 4);
      covariance->SetSampleInterpolation(setting / 4 % 2);
      covariance->SetFilterStandardDeviation(setting < 8 ? 0.0 : 1.0);
      covariance->SetStorage(setting % 3);
      covariance->SetNoiseCorrection(setting % 5 == 0);
      CheckFinite(covariance, image, name, report);
    }
  }
}

// Normals must not depend on the unit of the scalar.
void CheckUnit(double unit, int type, testing::Report& report)
{
  testing::Geometry geometry;
  geometry.Extent = { 0, 11, 0, 11, 0, 11 };
  auto field = [](const glm::dvec3& p) { return std::sin(0.5 * p.x) + 0.3 * p.y - 0.02 * p.z * p.z; };
  vtkNew<vtkSobelNormalFilter> plain;
  plain->SetInputData(testing::MakeImage(geometry, field, VTK_DOUBLE));
  plain->Update();
  const auto image = testing::MakeImage(
    geometry, [&](const glm::dvec3& p) { return unit * field(p); }, type);
  const std::string name = "scalars of " + std::to_string(std::log10(unit)) + " powers of ten";
  CheckImage(image, name, report);
  vtkNew<vtkSobelNormalFilter> scaled;
  scaled->SetInputData(image);
  scaled->Update();
  double worst = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    worst = std::max(worst,
      glm::length(testing::VectorAt(plain->GetOutput()->GetPointData()->GetArray("Normals"), i) -
        testing::VectorAt(scaled->GetOutput()->GetPointData()->GetArray("Normals"), i)));
  }
  report.CheckAtMost(worst, 1.0e-5, name + ": largest change of a normal");
}
}

int TestFilterExtremes(int, char*[])
{
  vtkFloatingPointExceptions::Disable(); // comparisons with NaN are meant
  testing::Report report;
  const testing::Field wave = [](const glm::dvec3& p) {
    return std::sin(p.x) + std::cos(1.3 * p.y) + 0.1 * p.z;
  };
  testing::Geometry geometry;
  for (const auto& extent :
    { std::array<int, 6>{ 0, 0, 0, 0, 0, 0 }, { 3, 3, -5, -5, 7, 7 }, { 0, 15, 0, 15, 4, 4 },
      { 0, 15, 2, 2, 0, 15 }, { -1, -1, 0, 15, 0, 15 }, { 0, 15, 0, 0, 0, 0 }, { 0, 1, 0, 1, 0, 1 } })
  {
    geometry.Extent = extent;
    CheckImage(testing::MakeImage(geometry, wave), "thin volume", report);
  }
  geometry.Extent = { 0, 12, 0, 12, 0, 12 };
  CheckImage(testing::MakeImage(geometry, [](const glm::dvec3&) { return 7.0; }), "constant volume", report);
  for (const glm::dvec3& spacing : { glm::dvec3(1.0e-6), glm::dvec3(1.0e6), glm::dvec3(1.0, 1.0, 100.0),
         glm::dvec3(100.0, 1.0, 1.0), glm::dvec3(-1.0, 1.0e-6, 1.0) })
  {
    geometry.Spacing = spacing;
    CheckImage(testing::MakeImage(geometry, [&](const glm::dvec3& p) { return wave(p / spacing); }),
      "spacing " + std::to_string(spacing.x), report);
  }
  geometry.Spacing = glm::dvec3(1.0);
  for (const double unit : { 1.0e-30, 1.0e30 })
  {
    CheckUnit(unit, VTK_FLOAT, report);
  }
  CheckUnit(1.0e-300, VTK_DOUBLE, report);
  CheckUnit(1.0e300, VTK_DOUBLE, report);
  CheckUnit(1.0e17, VTK_LONG_LONG, report);

  const double missing[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  CheckImage(testing::MakeImage(geometry,
               [&](const glm::dvec3& p) {
                 return testing::Noise(p) < 0.3 ? missing[static_cast<int>(3.0 * testing::Noise(p, 2.0))]
                                                : wave(p);
               }),
    "missing values", report);
  CheckImage(
    testing::MakeImage(geometry, [&](const glm::dvec3&) { return missing[0]; }), "nothing but NaN", report);
  const auto blanked = testing::MakeImage(geometry, wave);
  blanked->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < blanked->GetNumberOfPoints(); i += 3)
  {
    blanked->GetPointGhostArray()->SetValue(i, vtkDataSetAttributes::HIDDENPOINT);
  }
  CheckImage(blanked, "blanked points", report);
  return report.ExitCode();
}
