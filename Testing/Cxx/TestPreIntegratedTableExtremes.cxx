// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The pre-integrated table at the edges: functions, ranges, sizes and settings that are extreme or refused,
// and what is built when.

#include "TableTesting.h"
#include "TestScene.h"

#include "vtkSMPTools.h"

#include <limits>
#include <string>
#include <vector>

namespace
{
void CheckEntries(Check& check, const std::string& what, TestTable& t)
{
  check.That(t.Table->Update(), what + " makes a table");
  const float* entries = t.Table->GetEntries();
  const std::size_t count = static_cast<std::size_t>(t.Table->GetSize()) * t.Table->GetSize();
  double least = 0.0;
  double largest = 0.0;
  double largestColor = 0.0;
  for (std::size_t i = 0; i < 4 * count; ++i)
  {
    if (!std::isfinite(entries[i]))
    {
      check.Finite(what + ", an entry", entries[i]);
    }
    least = std::min<double>(least, entries[i]);
    double& bound = i % 4 == 3 ? largest : largestColor;
    bound = std::max<double>(bound, entries[i]);
  }
  check.AtLeast(what + ", the least number", least, 0.0);
  check.AtMost(what + ", the largest colour", largestColor, 1.0);
  check.Near(what + ", the largest mean", largest, t.Table->GetLargestMean(), 0.0);
}

// Opacity 1: on a point it is a finite attenuation, on an interval it is opaque.
void TestOpaque(Check& check)
{
  TestTable point;
  point.AddPeak(0.5, 0.1, 1.0);
  CheckEntries(check, "an opaque point", point);
  check.Near(
    "attenuation of an opaque point", point.Depth(0.0, 1.0), 0.2, 1.0e-6); // the integral of -ln x is 1
  TestTable plateau;
  plateau.AddPeak(0.5, 0.1, 1.0);
  plateau.Opacity->AddPoint(0.52, 1.0);
  CheckEntries(check, "an opaque interval", plateau);
  const double opacity = optics::SegmentOpacity(plateau.Table->GetMean(0.505, 0.506), 0.001);
  check.Near("opacity of an opaque interval", opacity, 1.0, 0.0);
  check.Near("where the scalar does not change", plateau.Depth(0.51, 0.51), 0.0, 0.0);
}

// A step and coincident nodes, each at a place that is no entry.
void TestSteps(Check& check)
{
  TestTable t;
  t.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  t.Color->AddRGBPoint(0.41, 1.0, 0.0, 0.0);
  t.Color->AddRGBPoint(0.41, 0.0, 0.0, 1.0);
  t.Opacity->AddPoint(0.0, 0.0);
  t.Opacity->AddPoint(0.3, 0.0);
  t.Opacity->AddPoint(0.3, 0.5);
  t.Opacity->AddPoint(0.5, 0.5, 0.25, 1.0); // a step at a quarter of the way
  t.Opacity->AddPoint(0.7, 0.0);
  CheckEntries(check, "steps", t);
  const double depth = std::log(2.0) * 0.25;
  check.Near("attenuation of a box", t.Depth(0.0, 1.0), depth, 1.0e-6 * depth);
  const double red = 0.11 / 0.25;
  // little attenuation: the colours' mean by their widths, up to what the first hides of the second
  check.Near("its colour", t.Entry(0, 255)[0], red, 0.05);
  check.AtLeast("its colour is nearer the front's", t.Entry(0, 255)[0], t.Entry(255, 0)[0]);
}

void TestRanges(Check& check)
{
  for (double scale : { 1.0e-30, 1.0e-6, 1.0e6, 1.0e30 })
  {
    TestTable t(64);
    TestTable one(64);
    one.AddPeak(0.4, 0.3, 0.9);
    one.Table->SetUnitInterval(0.01);
    t.AddPeak(0.4 * scale, 0.3 * scale, 0.9);
    t.Table->SetUnitInterval(0.01 * scale);
    t.Table->SetRange(0.0, scale);
    CheckEntries(check, "a range of " + std::to_string(scale), t);
    one.Table->Update();
    for (int i = 0; i < 64; i += 7)
    {
      const double mean = one.Entry(i, 40)[3];
      check.Near("mean at another scale", t.Entry(i, 40)[3], mean, 1.0e-6 * mean);
      const double between = one.Table->GetMean(i / 63.0, 0.111);
      check.Near("looked up", t.Table->GetMean(i / 63.0 * scale, 0.111 * scale), between, 1.0e-5 * between);
    }
  }
  TestTable far;
  far.AddPeak(0.5, 0.2, 0.9);
  far.Table->SetRange(2.0, 3.0);
  CheckEntries(check, "a range beside the functions", far);
  check.Near("nothing there", far.Table->GetLargestMean(), 0.0, 0.0);
  check.Near("colour of what is not there", far.Entry(0, 255)[2], 0.8, 1.0e-6);
}

void TestAttenuations(Check& check)
{
  double former = 0.0;
  for (double unit : { 0.0, 1.0e30, 1.0, 1.0e-3, 1.0e-8, 1.0e-37, 1.0e-290 })
  {
    TestTable t(64);
    t.AddPeak(0.5, 0.5, 0.9);
    t.Table->SetUnitInterval(unit);
    CheckEntries(check, "a unit interval of " + std::to_string(unit), t);
    if (unit > 0.0)
    {
      check.AtLeast("monotone in attenuation", t.Table->GetLargestMean(), former);
      former = t.Table->GetLargestMean();
    }
  }
  TestTable byDefault;
  byDefault.AddPeak(0.5, 0.25, 0.9);
  byDefault.Table->SetUnitInterval(0.0);
  byDefault.Table->Update();
  TestTable explicitly;
  explicitly.AddPeak(0.5, 0.25, 0.9);
  explicitly.Table->SetUnitInterval(0.005);
  explicitly.Table->Update();
  check.Near("the default unit interval is a hundredth of the opacity function's range",
    byDefault.Table->GetMean(0.3, 0.6), explicitly.Table->GetMean(0.3, 0.6), 1.0e-4);
}

// Physical space: the colour's own attenuation, from none to all of it, and the same mean.
void TestLengths(Check& check)
{
  for (double length : { 1.0e-30, 1.0e-3, 1.0, 1.0e3, 1.0e30 })
  {
    TestTable t(64);
    t.Color->AddRGBPoint(0.0, 0.0, 0.5, 1.0);
    t.Color->AddRGBPoint(1.0, 1.0, 0.5, 0.0);
    t.Opacity->AddPoint(0.5, 0.5);
    t.Table->SetSegmentLength(length);
    CheckEntries(check, "a length of " + std::to_string(length), t);
    check.Near("mean of a constant function", t.Table->GetMean(0.1, 0.7), std::log(2.0), 1.0e-6);
    const double depth = std::log(2.0) * length;
    const double along = depth < 1.0e-4 ? 0.5 : 1.0 / depth - 1.0 / std::expm1(depth);
    check.Near("colour upwards", t.Entry(0, 63)[0], along, 1.0 / 512.0);
    check.Near("colour downwards", t.Entry(63, 0)[0], 1.0 - along, 1.0 / 512.0);
  }
}

void TestInvalidOpacities(Check& check)
{
  TestTable t(64);
  t.Color->AddRGBPoint(0.0, 0.2, 0.4, 0.8);
  t.Opacity->AddPoint(0.1, -3.0);
  t.Opacity->AddPoint(0.4, 7.0);
  t.Opacity->AddPoint(0.6, std::numeric_limits<double>::quiet_NaN());
  t.Opacity->AddPoint(0.8, 0.5);
  t.Color->AddRGBPoint(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.5);
  CheckEntries(check, "opacities outside of [0, 1], and no numbers", t);
}

// What VTK's functions can be set to.
void TestFunctionSettings(Check& check)
{
  TestTable t(64);
  t.Color->AddRGBPoint(0.1, 0.2, 0.4, 0.8);
  t.Color->AddRGBPoint(0.9, 0.9, 0.5, 0.1);
  t.Opacity->AddPoint(0.31, 0.5);
  t.Opacity->AddPoint(0.62, 0.5);
  for (int space :
    { VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING, VTK_CTF_LAB_CIEDE2000, VTK_CTF_STEP })
  {
    t.Color->SetColorSpace(space);
    CheckEntries(check, "colour space " + std::to_string(space), t);
  }
  t.Color->SetColorSpaceToRGB();
  t.Color->SetScaleToLog10();
  CheckEntries(check, "a logarithmic scale", t);
  const double middle = std::sqrt(0.1 * 0.9); // 0.3 is 19.9/63 of the way
  check.Near("its middle", t.Table->GetMean(middle, middle), std::log(2.0), 1.0e-6);
  double rgba[4];
  t.Table->GetEntry(middle, middle, rgba);
  check.Near("colour of its middle", rgba[0], 0.55, 0.003);
  t.Opacity->ClampingOff();
  CheckEntries(check, "without clamping", t);
  const double depth = std::log(2.0) * 0.31;
  check.Near("nothing outside of the nodes", t.Depth(0.0, 1.0), depth, 1.0e-6);
}

void TestLargestSize(Check& check)
{
  TestTable t(4096);
  t.AddPeak(0.5, 0.3, 0.9);
  vtkSMPTools::Initialize(2);
  CheckEntries(check, "the largest table", t);
  check.Near(
    "memory", static_cast<double>(t.Table->GetMemorySize()), 4.0 * (4.0 * 4096 * 4096 + 3.0 * 4096), 0.0);
  t.Table->SetSegmentLength(1.0);
  t.Table->SetSize(2);
  CheckEntries(check, "the smallest table", t);
}

void TestErrors(Check& check)
{
  TestTable t;
  Warnings messages(t.Table);
  const auto refuses = [&](const std::string& message, const std::string& what) {
    check.That(!t.Table->Update() && !t.Table->Update(), what + " is refused");
    check.That(messages.Texts.size() == 1, what + " is said once");
    check.That(messages.Texts.front().find(message) != std::string::npos, what + " is named");
    check.That(!t.Table->GetEntries() && t.Table->GetMean(0.0, 1.0) == 0.0, what + " leaves the table empty");
    messages.Texts.clear();
  };
  refuses("color function has no node", "an empty colour function");
  t.AddPeak(0.5, 0.2, 0.5);
  for (double end :
    { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    t.Table->SetRange(0.0, end);
    refuses("not valid", "a range to " + std::to_string(end));
  }
  t.Table->SetRange(0.0, 1.0);
  t.Table->SetOpacityFunction(nullptr);
  refuses("no opacity function", "no function");
  t.Table->SetOpacityFunction(t.Opacity);
  check.That(t.Table->Update(), "what is put right works");
  t.Table->SetSize(1);
  check.That(messages.Texts.size() == 1 && t.Table->GetSize() == 2, "a size out of range");
  t.Table->SetUnitInterval(-1.0);
  t.Table->SetSegmentLength(-1.0);
  check.That(messages.Texts.size() == 3, "intervals and lengths below 0");
}

void TestRebuild(Check& check)
{
  TestTable t(16);
  t.AddPeak(0.5, 0.2, 0.5);
  t.Table->Update();
  const vtkMTimeType built = t.Table->GetBuildTime();
  t.Table->Update();
  t.Table->SetSize(16);
  t.Table->SetRange(0.0, 1.0);
  t.Table->Update();
  check.That(t.Table->GetBuildTime() == built, "nothing changed, nothing built");
  const double former = t.Table->GetMean(0.0, 1.0);
  t.Opacity->AddPoint(0.5, 0.7);
  t.Table->Update();
  check.That(t.Table->GetBuildTime() > built && t.Table->GetMean(0.0, 1.0) > former, "a function changed");
}
}

int TestPreIntegratedTableExtremes(int, char*[])
{
  Check check;
  TestOpaque(check);
  TestSteps(check);
  TestRanges(check);
  TestAttenuations(check);
  TestLengths(check);
  TestInvalidOpacities(check);
  TestFunctionSettings(check);
  TestLargestSize(check);
  TestErrors(check);
  TestRebuild(check);
  return check.ExitCode();
}
