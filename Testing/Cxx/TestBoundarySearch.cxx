// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The first guess of a lighting transfer function: on fields of known materials with blurred boundaries
// each range holds its material's scalar and no other's, and the boundaries are those of the field.

#include "FilterTesting.h"
#include "TestScene.h"
#include "vtkGradientAlignedHistogram.h"
#include "vtkLightingTransferFunction.h"

#include <algorithm>
#include <set>

namespace
{
using testing::Report;

struct Phantom
{
  std::string Name;
  std::vector<double> Materials; // of concentric shells, from inside
  std::vector<double> Radii;     // between them, rising
  double Blur = 1.0;             // standard deviation, voxels
  double Noise = 0.0;            // amplitude, relative to the range of materials
  double Step = 1.0;
};

// Steps blurred by a Gaussian across the radius.
double Shells(const Phantom& phantom, const glm::dvec3& p)
{
  const double radius = glm::length(p - glm::dvec3(31.5));
  double value = phantom.Materials[0];
  for (std::size_t i = 0; i < phantom.Radii.size(); ++i)
  {
    const double share = 0.5 * std::erfc(-(radius - phantom.Radii[i]) / phantom.Blur / std::sqrt(2.0));
    value += share * (phantom.Materials[i + 1] - phantom.Materials[i]);
  }
  const auto range = std::minmax_element(phantom.Materials.begin(), phantom.Materials.end());
  return value + phantom.Noise * (*range.second - *range.first) * (2.0 * testing::Noise(p) - 1.0);
}

// The pair of materials that a boundary's ranges hold, -1 for a range without exactly one.
std::pair<int, int> MaterialsOf(
  vtkLightingTransferFunction* function, int boundary, const std::vector<double>& materials)
{
  int found[2] = { -1, -1 };
  for (int side = 0; side < 2; ++side)
  {
    double range[2];
    function->GetRange(boundary, side, range);
    int count = 0;
    for (std::size_t i = 0; i < materials.size(); ++i)
    {
      if (materials[i] >= range[0] && materials[i] <= range[1])
      {
        found[side] = ++count == 1 ? static_cast<int>(i) : -1;
      }
    }
  }
  return { std::min(found[0], found[1]), std::max(found[0], found[1]) };
}

void CheckPhantom(const Phantom& phantom, Report& report)
{
  testing::Geometry geometry;
  geometry.Extent = { 0, 63, 0, 63, 0, 63 };
  vtkNew<vtkGradientAlignedHistogram> histogram;
  histogram->SetInputData(
    testing::MakeImage(geometry, [&](const glm::dvec3& p) { return Shells(phantom, p); }));
  histogram->SetStepLength(phantom.Step);
  histogram->Update();
  vtkNew<vtkLightingTransferFunction> function;
  const int count = function->InitializeFromHistogram(histogram->GetOutput(), 8);
  std::set<std::pair<int, int>> expected;
  for (std::size_t i = 0; i + 1 < phantom.Materials.size(); ++i)
  {
    expected.insert({ static_cast<int>(i), static_cast<int>(i) + 1 });
  }
  std::set<std::pair<int, int>> found;
  for (int i = 0; i < count; ++i)
  {
    const auto pair = MaterialsOf(function, i, phantom.Materials);
    found.insert(pair);
    double a[2];
    double b[2];
    function->GetRange(i, 0, a);
    function->GetRange(i, 1, b);
    std::cout << phantom.Name << ": [" << a[0] << ", " << a[1] << "] to [" << b[0] << ", " << b[1]
              << "], materials " << pair.first << " and " << pair.second << std::endl;
  }
  report.Check(found == expected && count == static_cast<int>(expected.size()),
    phantom.Name + ": the boundaries are those of the phantom");
}

// A thin shell in the inner one of two materials. What its middle has, varies with the direction: no other
// scalars beyond the materials, and no homogeneous region.
void CheckThinShell(double direction, double noise, Report& report)
{
  const Phantom phantom = { "thin shell", { 0.0, -direction * 100.0 }, { 24.0 }, 1.0, noise };
  testing::Geometry geometry;
  geometry.Extent = { 0, 63, 0, 63, 0, 63 };
  vtkNew<vtkGradientAlignedHistogram> histogram;
  histogram->SetInputData(testing::MakeImage(geometry, [&](const glm::dvec3& p) {
    const glm::dvec3 ray = p - glm::dvec3(31.5);
    const double distance = (glm::length(ray) - 14.0) / 1.2;
    const double middle = 110.0 + 70.0 * std::sin(0.2 * p.x) + 70.0 * std::cos(0.23 * p.y);
    return Shells(phantom, p) + direction * middle * std::exp(-0.5 * distance * distance);
  }));
  histogram->Update();
  vtkNew<vtkLightingTransferFunction> function;
  const int count = function->InitializeFromHistogram(histogram->GetOutput(), 3);
  int surfaces = 0;
  for (int i = 0; i < count; ++i)
  {
    surfaces += MaterialsOf(function, i, phantom.Materials) == std::make_pair(0, 1) ? 1 : 0;
  }
  report.Check(
    count == 2 && surfaces == 1, "the surface and a thin shell towards " + std::to_string(direction));
  const double least = direction * 40.0; // of what the shell should have beyond its neighbour
  const double most = direction * 200.0;
  for (const double scalar : { least, most })
  {
    double k[3];
    function->Evaluate(scalar, 0.0, k);
    report.CheckAtLeast(k[1], 0.5, "light between the shell and its neighbour");
    function->Evaluate(scalar, scalar, k);
    report.CheckAtMost(k[1], 0.0, "light within the shell");
  }
  double homogeneous[3];
  function->Evaluate(0.0, 0.0, homogeneous);
  report.CheckAtMost(homogeneous[1], 0.0, "light within its neighbour");
}

// Counts of two materials at 20 and 70 and of a varying one beyond, which has a weak mode at 130: it is one
// material as a whole.
void CheckModeByChance(Report& report)
{
  vtkNew<vtkImageData> histogram;
  histogram->SetDimensions(256, 256, 1);
  histogram->AllocateScalars(VTK_DOUBLE, 1);
  histogram->GetPointData()->GetScalars()->Fill(0.0);
  const auto add = [&](int s1, int s2, double count) {
    histogram->SetScalarComponentFromDouble(
      s1, s2, 0, 0, count + histogram->GetScalarComponentAsDouble(s1, s2, 0, 0));
  };
  add(20, 20, 1e5);
  add(70, 70, 1e5);
  for (int scalar = 90; scalar < 180; ++scalar)
  {
    add(scalar, 70, 100.0);
    add(scalar, scalar, std::abs(scalar - 130) <= 3 ? 120.0 : 20.0);
  }
  vtkNew<vtkLightingTransferFunction> function;
  const int count = function->InitializeFromHistogram(histogram, 8);
  double k[2][3];
  function->Evaluate(90.0, 70.0, k[0]);
  function->Evaluate(179.0, 70.0, k[1]);
  report.Check(count == 1 && k[0][1] > 0.5 && k[1][1] > 0.5, "a mode by chance is no material");
}

// Counts near the boundary have light, those of homogeneous regions none.
void CheckLight(Report& report)
{
  const Phantom phantom = { "light", { 900.0, 100.0 }, { 18.0 }, 0.8, 0.01 };
  testing::Geometry geometry;
  geometry.Extent = { 0, 63, 0, 63, 0, 63 };
  vtkNew<vtkGradientAlignedHistogram> filter;
  filter->SetInputData(testing::MakeImage(geometry, [&](const glm::dvec3& p) { return Shells(phantom, p); }));
  filter->Update();
  vtkImageData* histogram = filter->GetOutput();
  vtkNew<vtkLightingTransferFunction> function;
  function->InitializeFromHistogram(histogram, 1);
  double onBoundary = 0.0;
  double lit = 0.0;
  double homogeneousLit = 0.0;
  for (vtkIdType i = 0; i < histogram->GetNumberOfPoints(); ++i)
  {
    const double* pair = histogram->GetPoint(i);
    double k[3];
    function->Evaluate(pair[0], pair[1], k);
    const double count = histogram->GetPointData()->GetScalars()->GetComponent(i, 0);
    const bool isMiddle = pair[0] - pair[1] > 0.7 * 800.0;
    onBoundary += isMiddle ? count : 0.0;
    lit += isMiddle && k[1] >= 0.35 ? count : 0.0;
    homogeneousLit += pair[0] - pair[1] < 0.1 * 800.0 && k[1] > 0.0 ? count : 0.0;
  }
  report.CheckAtLeast(onBoundary, 500.0, "pairs in the middle of the boundary");
  report.CheckAtLeast(lit / onBoundary, 0.95, "share of them at least half lit");
  report.CheckAtMost(homogeneousLit, 0.0, "lit pairs of homogeneous regions");
}

void CheckNothingToFind(Report& report)
{
  vtkNew<vtkLightingTransferFunction> function;
  const double range[2] = { 0.0, 1.0 };
  function->AddBoundary(range, range, 0.1, 0.1, 0.1);
  vtkNew<vtkGradientAlignedHistogram> histogram;
  const testing::Field fields[] = { [](const glm::dvec3&) { return 3.0; },
    [](const glm::dvec3& p) { return p.x; }, [](const glm::dvec3& p) { return 10.0 + testing::Noise(p); } };
  for (const testing::Field& field : fields)
  {
    histogram->SetInputData(testing::MakeImage(testing::Geometry{}, field));
    histogram->Update();
    report.CheckAtMost(function->InitializeFromHistogram(histogram->GetOutput(), 5), 0.0,
      "boundaries of a constant, a ramp, noise");
  }
  histogram->SetScalarRange(100.0, 200.0); // holds no scalar
  histogram->Update();
  report.CheckAtMost(
    function->InitializeFromHistogram(histogram->GetOutput(), 5), 0.0, "boundaries of no counts");
  histogram->SetNumberOfBins(1);
  histogram->Update();
  report.CheckAtMost(
    function->InitializeFromHistogram(histogram->GetOutput(), 5), 0.0, "boundaries of one bin");

  function->AddBoundary(range, range, 0.1, 0.1, 0.1);
  const Warnings warnings(function);
  vtkNew<vtkImageData> empty;
  function->InitializeFromHistogram(empty, 5);
  function->InitializeFromHistogram(nullptr, 5);
  report.Check(warnings.Texts.size() == 2 && function->GetNumberOfBoundaries() == 1,
    "without a histogram there is an error and nothing changes");
}

// The strongest come first, and no more than wanted.
void CheckNumber(Report& report)
{
  const Phantom phantom = { "number", { 200.0, 90.0, 0.0 }, { 9.0, 24.0 } };
  testing::Geometry geometry;
  geometry.Extent = { 0, 63, 0, 63, 0, 63 };
  vtkNew<vtkGradientAlignedHistogram> histogram;
  histogram->SetInputData(
    testing::MakeImage(geometry, [&](const glm::dvec3& p) { return Shells(phantom, p); }));
  histogram->Update();
  vtkNew<vtkLightingTransferFunction> function;
  const int count = function->InitializeFromHistogram(histogram->GetOutput(), 1);
  report.Check(count == 1 && MaterialsOf(function, 0, phantom.Materials) == std::make_pair(1, 2),
    "the boundary of the larger surface is the strongest");
  report.CheckAtMost(function->InitializeFromHistogram(histogram->GetOutput(), 0), 0.0, "none wanted");
}
}

int TestBoundarySearch(int, char*[])
{
  Report report;
  const Phantom phantoms[] = {
    { "two materials", { 200.0, 50.0 }, { 18.0 } },
    { "two materials, sharp", { 200.0, 50.0 }, { 18.0 }, 0.3 },
    { "two materials, blurred by 2 voxels", { 200.0, 50.0 }, { 18.0 }, 2.0 },
    { "two materials, step beyond the blur", { 200.0, 50.0 }, { 18.0 }, 1.0, 0.0, 3.0 },
    { "two materials, noise", { 200.0, 50.0 }, { 18.0 }, 1.0, 0.03 },
    { "negative and large scalars", { -1.0e6, 3.0e6 }, { 18.0 } },
    { "three materials, inner the highest", { 255.0, 100.0, 0.0 }, { 12.0, 24.0 } },
    { "three materials, equally spaced", { 0.0, 50.0, 100.0 }, { 12.0, 24.0 } },
    { "three materials, the middle between others", { 1000.0, 0.0, 600.0 }, { 14.0, 24.0 } },
    { "three materials, noise", { 255.0, 100.0, 0.0 }, { 12.0, 24.0 }, 1.0, 0.02 },
  };
  for (const Phantom& phantom : phantoms)
  {
    CheckPhantom(phantom, report);
  }
  for (const double direction : { 1.0, -1.0 })
  {
    CheckThinShell(direction, 0.0, report);
    CheckThinShell(direction, 0.02, report);
  }
  CheckModeByChance(report);
  CheckLight(report);
  CheckNothingToFind(report);
  CheckNumber(report);
  return report.ExitCode();
}
