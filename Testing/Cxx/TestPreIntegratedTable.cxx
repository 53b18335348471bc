// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The pre-integrated table: closed forms, and sums of small steps.

#include "TableTesting.h"

#include <string>

namespace
{
// A float's rounding; the table's sums in double lose nothing that a float shows.
constexpr double FloatRounding = 1.2e-7;

void TestConstantFunction(Check& check)
{
  for (int size : { 2, 3, 64, 4096 })
  {
    TestTable t(size);
    t.Color->AddRGBPoint(0.5, 0.2, 0.4, 0.8);
    t.Opacity->AddPoint(0.5, 0.3);
    t.Table->SetUnitInterval(0.1);
    check.That(t.Table->Update(), "a constant function is one");
    const double mean = -std::log(0.7) / 0.1;
    for (int i = 0; i < size; i += 1 + size / 10)
    {
      for (int j = 0; j < size; j += 1 + size / 10)
      {
        check.Near("mean of a constant function", t.Entry(i, j)[3], mean, FloatRounding * mean);
        check.Near("its colour", t.Entry(i, j)[1], 0.4, FloatRounding);
      }
    }
    check.Near("the largest mean", t.Table->GetLargestMean(), mean, FloatRounding * mean);
    check.Near("the whole attenuation", t.Table->GetCumulative()[size - 1], mean, FloatRounding * mean);
  }
}

// Where front and back are the same a segment has a length all the same.
void TestConstantFunctionInSpace(Check& check)
{
  TestTable t(3);
  t.Color->AddRGBPoint(0.5, 0.2, 0.4, 0.8);
  t.Opacity->AddPoint(0.5, 0.3);
  t.Table->SetSegmentLength(2.0);
  t.Table->Update();
  const double mean = -std::log(0.7);
  for (int i = 0; i < 9; ++i)
  {
    check.Near("mean per unit distance", t.Entry(i / 3, i % 3)[3], mean, FloatRounding * mean);
    check.Near("colour in physical space", t.Entry(i / 3, i % 3)[1], 0.4, FloatRounding);
  }
}

// A peak that stands for an isosurface of opacity one half: so opaque is every path across it, whatever
// the table's size and the number of steps, however narrow it is.
void TestPeak(Check& check)
{
  for (double halfWidth : { 0.1, 0.002, 1.0e-6 })
  {
    for (int size : { 2, 16, 256, 4096 })
    {
      TestTable t(size);
      t.AddPeak(0.437, halfWidth, 0.9);
      t.Table->SetUnitInterval(DepthOfPeak(halfWidth, 0.9) / std::log(2.0));
      t.Table->Update();
      const std::string what =
        "a peak of half width " + std::to_string(halfWidth) + ", " + std::to_string(size) + " entries";
      // A step that ends in the cell of a narrow peak has a part of it by interpolation; if the steps are about
      // as long as the cells, the parts do not add up to the whole.
      const double tolerance = size == 16 ? 0.06 : 0.02;
      const double one = optics::SegmentOpacity(t.Table->GetMean(0.0, 1.0), 1.0);
      check.Near(what + ", one step", one, 0.5, FloatRounding);
      for (int steps : { 1, 7, 37, 100, 254, 255, 300, 10000 })
      {
        for (double front : { 0.0, 1.0 })
        {
          const double opacity = optics::OneMinusExp(t.DepthOfSteps(front, 1.0 - front, steps));
          check.Near(what + ", " + std::to_string(steps) + " steps", opacity, 0.5, tolerance);
        }
      }
    }
  }
}

// Why the table holds means, and what is on its diagonal: [Kraus2005] has opacities there, and none at all
// where front and back are the same. Between N entries that is a kink: a step of ds of the range gets
// 1/(3 (N - 1) ds) times its opacity, 13 times here.
void TestDiagonal(Check& check)
{
  const int steps = 10000;
  TestTable t;
  t.AddPeak(0.5, 0.4, 0.9);
  t.Table->SetUnitInterval(DepthOfPeak(0.4, 0.9) / 3.88);
  t.Table->Update();
  check.Near("a total attenuation of 3.88 in small steps", t.DepthOfSteps(0.0, 1.0, steps), 3.88, 0.01);
  double ofOpacities = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double place = (i + 0.5) / steps * 255.0;
    const int cell = static_cast<int>(place);
    const double off =
      2.0 * (place - cell) * (1.0 - (place - cell)); // weight of the entries off the diagonal
    ofOpacities += off * optics::SegmentOpacity(t.Entry(cell, cell + 1)[3], 1.0 / 255.0);
  }
  check.Near("of a table of opacities, for comparison", ofOpacities, 50.0, 2.0);

  // a peak narrower than a cell
  TestTable narrow;
  narrow.AddPeak(0.5, 0.002, 0.9);
  narrow.Table->SetUnitInterval(DepthOfPeak(0.002, 0.9));
  narrow.Table->Update();
  check.Near("a narrow peak in small steps", narrow.DepthOfSteps(0.0, 1.0, steps), 1.0, 1.0e-3);
}

// The colour of a segment over a ramp of colours: the closed form, on every part of the range and both ways,
// also where a difference of integrals has lost every digit (16 in float, 36 in double) or is 0/0 (103, 745).
void TestTotalAttenuation(Check& check)
{
  for (double total : { 0.0, 1.0e-30, 1.0e-3, 1.0, 16.0, 36.0, 103.0, 745.0, 1.0e5, 1.0e8 })
  {
    TestTable t;
    t.Color->AddRGBPoint(0.0, 0.0, 0.5, 1.0);
    t.Color->AddRGBPoint(1.0, 1.0, 0.5, 0.0);
    t.Opacity->AddPoint(0.0, total > 0.0 ? 0.5 : 0.0);
    t.Table->SetUnitInterval(total > 0.0 ? std::log(2.0) / total : 1.0);
    t.Table->Update();
    for (int front : { 0, 1, 100, 250, 255 })
    {
      for (int back : { 0, 5, 99, 101, 254, 255 })
      {
        if (front == back)
        {
          continue; // the colour of a cell around it
        }
        const double change = (back - front) / 255.0;
        const double depth = total * std::abs(change);
        // mean of x with weight exp(-depth x) on [0, 1]
        const double along = depth < 1.0e-4 ? 0.5 - depth / 12.0 : 1.0 / depth - 1.0 / std::expm1(depth);
        const double red = front / 255.0 + change * along;
        const std::string what = "total attenuation " + std::to_string(total) + ", " + std::to_string(front) +
          " to " + std::to_string(back);
        const float* entry = t.Entry(front, back);
        // a stretch of colour within 1/1000 of the range is taken as linear in the optical depth
        check.Near(what + ", red", entry[0], red, 1.0e-6);
        check.Near(what + ", blue", entry[2], 1.0 - red, 1.0e-6);
        check.Near(what + ", mean", entry[3], total, FloatRounding * total);
      }
    }
  }
}

// What a peak's opacity is, wherever a segment begins: exact sums, by the cumulative table.
void TestCumulative(Check& check)
{
  TestTable t(128);
  t.AddPeak(0.4, 0.1, 1.0);
  t.AddPeak(0.7, 0.05, 0.5);
  t.Table->Update();
  const reference::TransferIntegral truth(t.Opacity, t.Color);
  const float* sums = t.Table->GetCumulative();
  const float* behind = t.Table->GetDepthsBehind();
  for (int i = 0; i < 128; ++i)
  {
    const double scalar = i / 127.0;
    const double sum = truth.Between(0.0, scalar, t.Attenuation()).depth;
    check.Near("cumulative attenuation", sums[i], sum, 1.0e-6 * sum);
    const bool first = scalar > 0.3 && scalar < 0.5;
    const bool second = scalar > 0.65 && scalar < 0.75;
    const double end = first ? 0.5 : 0.75;
    const double begin = first ? 0.3 : 0.65;
    const double above = first || second ? truth.Between(scalar, end, t.Attenuation()).depth : 0.0;
    const double below = first || second ? truth.Between(begin, scalar, t.Attenuation()).depth : 0.0;
    check.Near("attenuation to the end of the peak above", behind[2 * i], above, 1.0e-6);
    check.Near("attenuation to the end of the peak below", behind[2 * i + 1], below, 1.0e-6);
  }
}

// A number of pairs between its entries, of one end.
double DepthBehind(TestTable& t, double scalar, int end)
{
  const double place = t.Table->GetNormalizedScalar(scalar) * (t.Table->GetSize() - 1);
  const int entry = std::min(static_cast<int>(place), t.Table->GetSize() - 2);
  const float* depths = t.Table->GetDepthsBehind() + 2 * entry + end;
  return depths[0] + (place - entry) * (depths[2] - depths[0]);
}

// What a ray across a peak transmits, by the tables alone: A (1 - A), whatever its steps.
void TestTransmission(Check& check)
{
  for (double opacity : { 0.2, 0.5, 0.9, 0.9999 })
  {
    TestTable t;
    t.AddPeak(0.5, 0.2, 0.9);
    t.Table->SetUnitInterval(DepthOfPeak(0.2, 0.9) / -std::log1p(-opacity));
    t.Table->Update();
    for (int steps : { 1, 3, 10, 64, 1000 })
    {
      for (int end : { 0, 1 })
      {
        double light = 0.0;
        double transparency = 1.0;
        for (int i = 0; i < steps; ++i)
        {
          const double front = std::abs(end - static_cast<double>(i) / steps);
          const double back = std::abs(end - (i + 1.0) / steps);
          const double depth = t.Depth(front, back);
          const double peak = std::max(DepthBehind(t, front, 0) + DepthBehind(t, front, 1),
            DepthBehind(t, back, 0) + DepthBehind(t, back, 1));
          const double alpha = optics::OneMinusExp(depth);
          light += transparency * alpha * optics::TransmittedShare(depth, DepthBehind(t, back, end), peak);
          transparency *= 1.0 - alpha;
        }
        check.Near(
          "a peak of " + std::to_string(opacity) + " in " + std::to_string(steps) + " steps transmits", light,
          opacity * (1.0 - opacity), 1.0e-3);
      }
    }
  }
}

// The opacity of a segment of length d in physical space, and its colour by the length that was set.
void TestPhysicalSpace(Check& check)
{
  TestTable t(64);
  t.AddPeak(0.4, 0.2, 0.95);
  t.Color->RemoveAllPoints();
  t.Color->AddHSVPoint(0.0, 0.0, 1.0, 1.0);
  t.Color->AddHSVPoint(1.0, 0.9, 1.0, 1.0);
  t.Color->SetColorSpaceToHSV();
  t.Color->HSVWrapOff();
  for (double length : { 0.25, 8.0, 1000.0 })
  {
    t.Table->SetSegmentLength(length);
    t.Table->Update();
    const reference::TransferIntegral truth(t.Opacity, t.Color, 1.0e-6);
    for (int front : { 0, 20, 25, 63 })
    {
      for (int back : { 10, 24, 26, 40, 63 })
      {
        if (front == back)
        {
          continue;
        }
        const auto exact = truth.Between(front / 63.0, back / 63.0, length / std::abs(front - back) * 63.0);
        const float* entry = t.Entry(front, back);
        check.Near("mean in physical space", entry[3] * length, exact.depth, 1.0e-4 * exact.depth);
        for (int i = 0; i < 3 && exact.opacity > 0.0; ++i)
        {
          check.Near("colour in physical space", entry[i], exact.color[i] / exact.opacity, 1.0 / 500.0);
        }
      }
    }
  }
}
}

int TestPreIntegratedTable(int, char*[])
{
  Check check;
  TestConstantFunction(check);
  TestConstantFunctionInSpace(check);
  TestPeak(check);
  TestDiagonal(check);
  TestTotalAttenuation(check);
  TestCumulative(check);
  TestTransmission(check);
  TestPhysicalSpace(check);
  return check.ExitCode();
}
