// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Counts of pairs along the gradient: closed cases, a plain loop over the voxels as the truth, what is
// left out, pieces, scalar types, extremes.

#include "FilterTesting.h"
#include "TestScene.h"
#include "vtkGradientAlignedHistogram.h"
#include "vtkSobelNormalFilter.h"

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
using testing::Geometry;
using testing::Report;

double Sum(vtkImageData* histogram)
{
  vtkDataArray* counts = histogram->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; counts && i < counts->GetNumberOfTuples(); ++i)
  {
    sum += counts->GetComponent(i, 0);
  }
  return sum;
}

double Difference(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* countsA = a->GetPointData()->GetScalars();
  vtkDataArray* countsB = b->GetPointData()->GetScalars();
  if (!countsA || !countsB || countsA->GetNumberOfTuples() != countsB->GetNumberOfTuples())
  {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0.0;
  for (vtkIdType i = 0; i < countsA->GetNumberOfTuples(); ++i)
  {
    sum += std::abs(countsA->GetComponent(i, 0) - countsB->GetComponent(i, 0));
  }
  return sum;
}

double Wave(const glm::dvec3& p)
{
  return 50.0 + 20.0 * std::sin(0.5 * p.x + 0.2 * p.z) + 15.0 * std::cos(0.4 * p.y - 0.3 * p.z);
}

// On a linear field each voxel far from the border is at (s + h |a|, s - h |a|).
void CheckRamp(Report& report)
{
  Geometry geometry;
  geometry.Extent = { -3, 20, 2, 17, 5, 40 };
  geometry.Spacing = { 1.0, 1.5, 0.5 };
  geometry.Origin = { 3.0, -7.0, 1.0 };
  geometry.Direction = testing::Rotation();
  const glm::dvec3 slope(2.0, -1.0, 2.0);
  const auto image = testing::MakeImage(
    geometry, [&](const glm::dvec3& p) { return glm::dot(slope, p); }, VTK_DOUBLE);
  vtkNew<vtkGradientAlignedHistogram> filter;
  filter->SetInputData(image);
  filter->SetStepLength(1.5); // of 0.5
  filter->SetNumberOfBins(1000);
  filter->Update();
  vtkImageData* histogram = filter->GetOutput();
  const double bin = histogram->GetSpacing()[0];
  vtkDataArray* counts = histogram->GetPointData()->GetScalars();
  double onLine = 0.0;
  double beyond = 0.0;
  for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
  {
    double pair[3];
    histogram->GetPoint(i, pair);
    const double off = pair[0] - pair[1] - 2.0 * 0.75 * 3.0;
    onLine += std::abs(off) <= bin * 1.001 ? counts->GetComponent(i, 0) : 0.0;
    beyond += off > bin * 1.001 ? counts->GetComponent(i, 0) : 0.0;
  }
  // the step reaches 0.75, 0.5 and 1.5 voxels: two voxels at either side of z, one of x and y
  report.CheckAtLeast(onLine, 22.0 * 14.0 * 32.0, "voxels on the ramp's line");
  report.CheckAtMost(beyond, 0.0, "voxels that differ by more than the ramp allows");
  report.Check(Sum(histogram) == image->GetNumberOfPoints(), "each voxel of the ramp counts once");
  vtkImageData* gradients = filter->GetOutput(1);
  const int row = static_cast<int>(3.0 / gradients->GetSpacing()[1]);
  double atSlope = 0.0;
  for (int x = 0; x < 1000; ++x)
  {
    atSlope += gradients->GetScalarComponentAsDouble(x, row, 0, 0);
  }
  report.Check(atSlope == image->GetNumberOfPoints(), "the ramp's gradient is its slope everywhere");
}

// Trilinear with the border's value outside, on an image of spacing 1 at the origin.
double At(vtkImageData* image, const glm::dvec3& position)
{
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    int index[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double last = image->GetDimensions()[axis] - 1.0;
      const double inside = std::clamp(position[axis], 0.0, last);
      const double floor = std::floor(inside);
      const bool next = (corner >> axis & 1) != 0;
      weight *= next ? inside - floor : 1.0 - inside + floor;
      index[axis] = static_cast<int>(std::min(floor + next, last));
    }
    value += weight * image->GetScalarComponentAsDouble(index[0], index[1], index[2], 0);
  }
  return value;
}

void CheckAgainstLoop(Report& report)
{
  const auto image = testing::MakeImage(Geometry{}, Wave, VTK_DOUBLE);
  vtkNew<vtkSobelNormalFilter> sobel;
  sobel->SetInputData(image);
  sobel->Update();
  vtkDataArray* normals = sobel->GetOutput()->GetPointData()->GetArray("Normals");
  for (const double step : { 0.5, 1.0, 3.3, 200.0 })
  {
    vtkNew<vtkGradientAlignedHistogram> filter;
    filter->SetInputData(image);
    filter->SetNumberOfBins(64);
    filter->SetScalarRange(10.0, 90.0);
    filter->SetStepLength(step);
    filter->Update();
    vtkNew<vtkImageData> expected;
    expected->DeepCopy(filter->GetOutput());
    expected->GetPointData()->GetScalars()->Fill(0.0);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 point;
      image->GetPoint(i, &point.x);
      const glm::dvec3 normal = testing::VectorAt(normals, i);
      const int s1 = static_cast<int>((At(image, point - step * normal) - 10.0) / 1.25);
      const int s2 = static_cast<int>((At(image, point + step * normal) - 10.0) / 1.25);
      auto* count = static_cast<double*>(expected->GetScalarPointer(s1, s2, 0));
      *count += 1.0;
    }
    // normals are stored in float: of 32768 voxels those within 1e-5 of a bin's border may move
    report.CheckAtMost(Difference(filter->GetOutput(), expected), 8.0,
      "pairs that differ from a plain loop, step " + std::to_string(step));
  }
}

void CheckLeftOut(Report& report)
{
  Geometry geometry;
  geometry.Extent = { 0, 11, 0, 11, 0, 11 };
  const auto image = testing::MakeImage(geometry, Wave, VTK_FLOAT);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfPoints());
  ghosts->Fill(0);
  for (int i = 0; i < 144; ++i)
  {
    ghosts->SetValue(i, vtkDataSetAttributes::DUPLICATEPOINT); // z = 0
  }
  image->GetPointData()->AddArray(ghosts);
  vtkNew<vtkGradientAlignedHistogram> filter;
  filter->SetInputData(image);
  filter->Update();
  report.Check(Sum(filter->GetOutput()) == 11.0 * 144.0, "points of another piece are left out");
  report.Check(Sum(filter->GetOutput(1)) == 11.0 * 144.0, "also of the gradients");

  int hidden[3] = { 6, 6, 6 };
  ghosts->SetValue(image->ComputePointId(hidden), vtkDataSetAttributes::HIDDENPOINT);
  ghosts->Modified();
  image->Modified();
  filter->Update();
  const double left = Sum(filter->GetOutput());
  // the voxel itself, and those of its 26 neighbours whose samples need it
  report.CheckAtMost(left, 11.0 * 144.0 - 1.0, "voxels with a blanked one");
  report.CheckAtLeast(left, 11.0 * 144.0 - 27.0, "voxels with a blanked one");
  ghosts->SetValue(image->ComputePointId(hidden), 0);
  *static_cast<float*>(image->GetScalarPointer(6, 6, 6)) = std::numeric_limits<float>::quiet_NaN();
  ghosts->Modified();
  image->Modified();
  filter->Update();
  report.Check(Sum(filter->GetOutput()) == left, "NaN is left out as a blanked point is");
  filter->SetScalarRange(40.0, 60.0);
  filter->Update();
  report.CheckAtMost(Sum(filter->GetOutput()), left - 100.0, "voxels in a narrow range");
  report.CheckAtLeast(Sum(filter->GetOutput()), 100.0, "voxels in a narrow range");
}

// Two halves with three ghost layers add up to the whole.
void CheckPieces(Report& report)
{
  const auto image = testing::MakeImage(Geometry{}, Wave, VTK_FLOAT);
  vtkNew<vtkGradientAlignedHistogram> filter;
  filter->SetScalarRange(10.0, 90.0);
  filter->SetStepLength(1.7);
  filter->SetInputData(image);
  filter->Update();
  vtkNew<vtkImageData> rest;
  rest->DeepCopy(filter->GetOutput());
  vtkDataArray* counts = rest->GetPointData()->GetScalars();
  for (const bool isUpper : { false, true })
  {
    vtkNew<vtkImageData> half;
    half->DeepCopy(image);
    const int extent[6] = { 0, 31, 0, 31, isUpper ? 13 : 0, isUpper ? 31 : 18 };
    half->Crop(extent);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < half->GetNumberOfPoints(); ++i)
    {
      const bool isOwn = (half->GetPoint(i)[2] >= 16.0) == isUpper;
      ghosts->InsertNextValue(isOwn ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
    }
    half->GetPointData()->AddArray(ghosts);
    filter->SetInputData(half);
    filter->Update();
    vtkDataArray* part = filter->GetOutput()->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
    {
      counts->SetComponent(i, 0, counts->GetComponent(i, 0) - part->GetComponent(i, 0));
    }
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, std::abs(counts->GetComponent(i, 0)));
  }
  report.CheckAtMost(largest, 0.0, "the whole's counts less the pieces'");
}

void CheckTypes(Report& report)
{
  const auto rounded = [](const glm::dvec3& p) { return std::round(Wave(p)); };
  vtkNew<vtkGradientAlignedHistogram> expected;
  expected->SetInputData(testing::MakeImage(Geometry{}, rounded, VTK_DOUBLE));
  expected->Update();
  for (const int type :
    { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT,
      VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT })
  {
    vtkNew<vtkGradientAlignedHistogram> filter;
    filter->SetInputData(testing::MakeImage(Geometry{}, rounded, type));
    filter->Update();
    report.CheckAtMost(Difference(filter->GetOutput(), expected->GetOutput()), 0.0,
      std::string("differences of ") + vtkImageScalarTypeNameMacro(type));
  }
}

void CheckExtremes(Report& report)
{
  vtkNew<vtkGradientAlignedHistogram> filter;
  filter->SetNumberOfBins(16);
  struct Case
  {
    const char* Name;
    std::array<int, 6> Extent;
    testing::Field Scalar;
    double Expected; // voxels
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto constant = [](const glm::dvec3&) { return 7.0; };
  const Case cases[] = {
    { "constant", { 0, 7, 0, 7, 0, 7 }, constant, 512.0 },
    { "one voxel", { 0, 0, 0, 0, 0, 0 }, constant, 1.0 },
    { "one slice", { 0, 7, 0, 7, 0, 0 }, Wave, 64.0 },
    { "all NaN", { 0, 3, 0, 3, 0, 3 }, [nan](const glm::dvec3&) { return nan; }, 0.0 },
    { "values of 1e300", { 0, 7, 0, 7, 0, 7 }, [](const glm::dvec3& p) { return 1e300 * p.x; }, 512.0 },
    { "values of 1e-310", { 0, 7, 0, 7, 0, 7 }, [](const glm::dvec3& p) { return 1e-310 * p.x; }, 512.0 },
    { "constant of 1e30", { 0, 7, 0, 7, 0, 7 }, [](const glm::dvec3&) { return 1e30; }, 512.0 },
  };
  for (const Case& test : cases)
  {
    Geometry geometry;
    geometry.Extent = test.Extent;
    for (const double step : { 1.0, 1000.0 })
    {
      filter->SetStepLength(step);
      filter->SetInputData(testing::MakeImage(geometry, test.Scalar, VTK_DOUBLE));
      filter->Update();
      report.Check(Sum(filter->GetOutput()) == test.Expected, std::string(test.Name) + ": voxels counted");
      report.Check(Sum(filter->GetOutput(1)) == test.Expected, std::string(test.Name) + ": in gradients");
    }
  }
  filter->SetNumberOfBins(1);
  filter->SetInputData(testing::MakeImage(Geometry{}, Wave));
  filter->Update();
  report.Check(Sum(filter->GetOutput()) == 32768.0, "one bin has all");
  vtkNew<vtkImageData> empty;
  filter->SetInputData(empty);
  filter->Update();
  report.Check(filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0 &&
      filter->GetOutput(1)->GetPointData()->GetNumberOfArrays() == 0,
    "an empty image leaves both outputs empty");
}

void CheckSettings(Report& report)
{
  vtkNew<vtkGradientAlignedHistogram> filter;
  const Warnings warnings(filter);
  filter->SetNumberOfBins(0);
  filter->SetStepLength(0.0);
  filter->SetScalarRange(0.0, std::numeric_limits<double>::infinity());
  report.Check(warnings.Texts.size() == 3, "three settings outside their range are said");
  report.Check(filter->GetNumberOfBins() == 1 && filter->GetStepLength() == 0.01, "nearest values are taken");
  report.Check(filter->GetScalarRange()[0] == 1.0, "an infinite range is not");
}
}

int TestGradientAlignedHistogram(int, char*[])
{
  Report report;
  CheckRamp(report);
  CheckAgainstLoop(report);
  CheckLeftOut(report);
  CheckPieces(report);
  CheckTypes(report);
  CheckExtremes(report);
  CheckSettings(report);
  return report.ExitCode();
}
