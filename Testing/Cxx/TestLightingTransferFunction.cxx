// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Coefficients of light by pairs of scalars: closed cases, tables against exact values, extremes, errors.

#include "LightingFunctions.h"
#include "TestScene.h"

#include "vtkPointData.h"

#include <sstream>

namespace
{
void CheckPairs(Check& check)
{
  vtkNew<Function> function;
  Add(function, 10.0, 20.0, 50.0, 60.0, 4.0);
  check.Near("ka in the box", At(function, 55.0, 15.0)[0], 0.1, Rounding);
  check.Near("kd in the box", At(function, 55.0, 15.0)[1], 0.5, Rounding);
  check.Near("ks in the box", At(function, 55.0, 15.0)[2], 0.25, Rounding);
  check.Near("the other order", At(function, 15.0, 55.0)[1], 0.5, Rounding);
  check.Near("one soft edge", At(function, 61.0, 15.0)[1], 0.5 * 0.75, Rounding);
  check.Near("two soft edges", At(function, 61.0, 8.0)[1], 0.5 * 0.75 * 0.5, Rounding);
  check.Near("beyond the edge", At(function, 64.0, 15.0)[1], 0.0, 0.0);
  check.Near("one material", At(function, 15.0, 15.0)[1], 0.0, 0.0);
  check.Near("the ends belong to the range", At(function, 60.0, 10.0)[1], 0.5, Rounding);
  for (const double bad : { std::nan(""), Infinity, -Infinity })
  {
    check.Near("no light where there is no scalar", At(function, bad, 15.0)[1], 0.0, 0.0);
  }

  // a box on the diagonal counts once
  vtkNew<Function> diagonal;
  Add(diagonal, 10.0, 20.0, 10.0, 20.0);
  check.Near("a material with itself", At(diagonal, 12.0, 18.0)[1], 0.5, Rounding);
}

void CheckSums(Check& check)
{
  vtkNew<Function> function;
  Add(function, 0.0, 10.0, 20.0, 30.0, 0.0, { 0.7, 0.2, 0.0 });
  Add(function, 5.0, 15.0, 20.0, 30.0, 0.0, { 0.7, 0.2, 0.1 });
  check.Near("overlapping boxes are summed", At(function, 25.0, 7.0)[1], 0.4, Rounding);
  check.Near("to 1 at most", At(function, 25.0, 7.0)[0], 1.0, 0.0);
  check.Near("one of them alone", At(function, 25.0, 12.0)[0], 0.7, Rounding);
  const std::vector<float> table = Table(function, 0.0, 32.0, 32);
  check.Near("in the table, too", table[4 * (32 * 7 + 25)], 1.0, 0.0);
}

void CheckExtremes(Check& check)
{
  vtkNew<Function> function;
  const int reversed = Add(function, 20.0, 10.0, 60.0, 50.0);
  check.Near("a reversed range is turned", At(function, 55.0, 15.0)[1], 0.5, Rounding);
  double range[2];
  function->GetRange(reversed, 0, range);
  check.That(range[0] == 10.0 && range[1] == 20.0, "and is read turned");

  Add(function, 30.0, 30.0, 80.0, 80.0);
  check.Near("a range of zero width has its value", At(function, 80.0, 30.0)[1], 0.5, Rounding);
  check.Near("and nothing else", At(function, 80.0, 30.0 + 1e-9)[1], 0.0, 0.0);
  function->SetSoftness(1, 2.0);
  check.Near("but soft edges", At(function, 80.0, 31.0)[1], 0.25, Rounding);

  Add(function, 1e3, 2e3, -5e3, -4e3, 1.0, { 1.0, 1.0, 1.0 });
  double largest = 0.0;
  for (const float value : Table(function, 100.0, 900.0, 16))
  {
    largest = std::max(largest, std::abs(double(value)));
  }
  check.AtMost("boxes outside of the table's range", largest, 0.0);

  for (const auto& [low, high] :
    { std::pair<double, double>{ 5.0, 5.0 }, { 90.0, 0.0 }, { -1e308, 1e308 }, { 0.0, 1e-310 } })
  {
    for (const float value : Table(function, low, high, 7))
    {
      check.That(value >= 0.0F && value <= 1.0F, "a strange range gives values in [0, 1]");
    }
  }
  // 1 x 1: the mean over the range; a of 10 of 100, b of 10 of 100 (and the narrow ones)
  vtkNew<Function> one;
  Add(one, 10.0, 20.0, 50.0, 60.0);
  const std::vector<float> table = Table(one, 0.0, 100.0, 1);
  check.That(table.size() == 4, "a table of 1 x 1 has four numbers");
  check.Near("its kd", table[1], 0.5 * 0.1 * 0.1, 1e-8);
  check.Near("of one point of a range", Table(one, 15.0, 15.0, 1)[1], 0.0, 0.0);
}

// Trapezoids' means are exact: against a fine sum of exact values where A is below B.
void CheckTableAgainstValues(Check& check)
{
  vtkNew<Function> function;
  Add(function, 11.3, 17.7, 48.2, 48.9, 3.1);
  Add(function, 25.0, 25.0, 60.0, 75.0, 0.7, { 0.9, 0.1, 0.3 });
  const int size = 20;
  const int fine = 200;
  const std::vector<float> table = Table(function, 0.0, 100.0, size);
  for (int row = 0; row < size; ++row)
  {
    for (int column = row + 1; column < size; ++column)
    {
      Triple mean = { 0.0, 0.0, 0.0 };
      for (int i = 0; i < fine * fine; ++i)
      {
        const int x = i % fine;
        const int y = i / fine;
        const Triple k = At(function, 5.0 * (column + (x + 0.5) / fine), 5.0 * (row + (y + 0.5) / fine));
        for (int channel = 0; channel < 3; ++channel)
        {
          mean[channel] += k[channel] / fine / fine;
        }
      }
      for (int channel = 0; channel < 3; ++channel)
      {
        // the midpoint sum is off by an edge's share of a fine cell, 1/200 of the largest slope of 5/.7
        check.Near("table at " + std::to_string(column) + ", " + std::to_string(row),
          table[4 * (row * size + column) + channel], mean[channel], 2e-4);
        check.Near("symmetry", table[4 * (row * size + column) + channel],
          table[4 * (column * size + row) + channel], 0.0);
      }
    }
  }
}

void CheckCurvesAndDensity(Check& check)
{
  vtkNew<vtkPiecewiseFunction> low;
  low->AddPoint(0.0, 1.0);
  low->AddPoint(10.0, 0.0);
  vtkNew<vtkPiecewiseFunction> high;
  high->AddPoint(50.0, 0.0);
  high->AddPoint(60.0, 2.0); // above 1
  vtkNew<Function> function;
  const int index = function->AddBoundary(low, high, 0.2, 0.8, 0.4);
  check.Near("the product of two curves", At(function, 52.5, 5.0)[1], 0.8 * 0.5 * 0.5, Rounding);
  check.Near("a weight is at most 1", At(function, 60.0, 0.0)[1], 0.8, Rounding);
  double range[2];
  function->GetRange(index, 1, range);
  check.That(range[0] == 50.0 && range[1] == 60.0, "the range of a curve");
  const vtkMTimeType before = function->GetMTime();
  low->AddPoint(20.0, 0.3);
  check.That(function->GetMTime() > before, "an edit of a curve is one of the function");
  vtkNew<vtkPiecewiseFunction> nothing;
  function->AddBoundary(nothing, nothing, 1.0, 1.0, 1.0);
  check.Near("curves without points have no light", At(function, 30.0, 30.0)[0], 0.0, 0.0);

  vtkNew<vtkPiecewiseFunction> density;
  density->AddPoint(0.0, 0.0);
  density->AddPoint(100.0, 1.0);
  const std::vector<float> table = Table(function, 0.0, 100.0, 10, density);
  check.Near("density at S1 less that at S2", table[4 * (10 * 2 + 7) + 3], 0.5, 1e-7);
  check.Near("and its sign", table[4 * (10 * 7 + 2) + 3], -0.5, 1e-7);
  check.Near("none without a density", Table(function, 0.0, 100.0, 10)[4 * 27 + 3], 0.0, 0.0);
}

void CheckImages(Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(3, 4, 0, 1, 0, 0); // points at 30, 40 and 0, 10
  image->SetSpacing(10.0, 10.0, 1.0);
  vtkNew<Function> function;
  function->SetTableFromImage(image);
  check.Near("an image without scalars", At(function, 35.0, 5.0)[0], 0.0, 0.0);
  for (const int components : { 1, 2, 3 })
  {
    image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
    image->GetPointData()->GetScalars()->Fill(0.0);
    image->SetScalarComponentFromDouble(4, 0, 0, 0, 255.0); // S1 = 40, S2 = 0
    const Triple k = At(function, 35.0, 5.0);
    const Triple expected = components == 1 ? Triple{ 0.25, 0.25, 0.25 } : Triple{ 0.25, 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      check.Near("linear between points", k[i], expected[i], Rounding);
    }
  }
  check.Near("the border's value outside", At(function, 1e9, -1e9)[0], 1.0, Rounding);
  check.Near("columns are S1", Table(function, 0.0, 40.0, 4)[4 * 3], 0.25, 1e-7);
  check.Near("rows are S2", Table(function, 0.0, 40.0, 4)[4 * 4 * 3], 0.0, 1e-7);
  Add(function, 40.0, 40.0, 0.0, 0.0, 0.0, { 0.5, 0.5, 0.5 });
  check.Near("a boundary is added to it", At(function, 40.0, 0.0)[1], 0.5, Rounding);
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  image->GetPointData()->GetScalars()->Fill(0.125);
  check.Near("an image of one point is the same everywhere", At(function, -7.0, 1e12)[2], 0.125, Rounding);
  image->GetPointData()->GetScalars()->Fill(std::nan(""));
  check.Near("NaN is no light", At(function, 0.0, 0.0)[2], 0.0, 0.0);
}

void CheckTables(Check& check)
{
  vtkNew<Function> function;
  Add(function, 10.0, 20.0, 50.0, 60.0);
  vtkNew<vtkImageData> image;
  const double range[2] = { 0.0, 100.0 };
  function->GetTable(range, 10, image);
  check.That(image->GetPoint(0)[0] == 5.0 && image->GetPoint(9)[0] == 95.0, "texels' centres are scalars");
  check.Near("kd of a texel", image->GetScalarComponentAsDouble(5, 1, 0, 1), 0.5, 0.0);
  const Warnings warnings(function);
  check.That(Table(function, 0.0, 1.0, 0).empty() && Table(function, 0.0, 1.0, 5000).empty() &&
      Table(function, 0.0, Infinity, 8).empty(),
    "bad tables are empty");
  check.That(warnings.Texts.size() == 3, "and said");
}

void CheckSettings(Check& check)
{
  vtkNew<Function> function;
  const Warnings warnings(function);
  check.That(Add(function, 0.0, 1.0, std::nan(""), 1.0) == -1, "NaN adds no boundary");
  check.That(Add(function, -Infinity, 1.0, 0.0, 1.0) == -1, "infinity neither");
  vtkPiecewiseFunction* noCurve = nullptr;
  check.That(function->AddBoundary(noCurve, noCurve, 0.0, 0.0, 0.0) == -1, "no curves neither");
  check.That(warnings.Texts.size() == 3, "each is said once");
  check.That(Add(function, 0.0, 1.0, 0.0, 1.0, 0.0, { -1.0, 2.0, std::nan("") }) == 0, "the first boundary");
  double k[3];
  function->GetCoefficients(0, k);
  check.That(k[0] == 0.0 && k[1] == 1.0 && k[2] == 0.0, "coefficients are in [0, 1]");
  check.That(warnings.Texts.size() == 6, "which is said");
  function->SetSoftness(0, -1.0);
  function->SetRange(0, 2, 0.0, 1.0);
  function->SetRange(0, 0, 0.0, Infinity);
  function->SetRange(1, 0, 0.0, 1.0);
  function->RemoveBoundary(-1);
  function->GetSoftness(9);
  check.That(warnings.Texts.size() == 12, "bad settings are said");

  vtkMTimeType time = function->GetMTime();
  const auto isNewer = [&](const char* what) {
    check.That(function->GetMTime() > time, std::string(what) + " changes the time");
    time = function->GetMTime();
  };
  function->SetRange(0, 0, 3.0, 4.0);
  isNewer("a range");
  function->SetRange(0, 0, 4.0, 3.0);
  check.That(function->GetMTime() == time, "the same range does not");
  function->SetSoftness(0, 1.0);
  isNewer("a softness");
  function->SetCoefficients(0, 0.1, 0.2, 0.3);
  isNewer("a coefficient");
  vtkNew<vtkImageData> image;
  function->SetTableFromImage(image);
  isNewer("a table");
  image->Modified();
  isNewer("an edit of the table");
  function->RemoveAllBoundaries();
  isNewer("removing");
  vtkNew<Function> other;
  Add(other, 0.0, 1.0, 2.0, 3.0);
  function->ShallowCopy(other);
  isNewer("a copy");
  check.That(function->GetNumberOfBoundaries() == 1 && !function->GetTableImage(), "a copy has the same");
  std::ostringstream text;
  function->Print(text);
  check.That(text.str().find("Softness") != std::string::npos, "PrintSelf has the boundaries");
}
}

int TestLightingTransferFunction(int, char*[])
{
  Check check;
  CheckPairs(check);
  CheckSums(check);
  CheckExtremes(check);
  CheckTableAgainstValues(check);
  CheckCurvesAndDensity(check);
  CheckImages(check);
  CheckTables(check);
  CheckSettings(check);
  return check.ExitCode();
}
