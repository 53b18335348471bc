// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeIntegration.h"

#include "CsvWriter.h"
#include "IntegrationBench.h"
#include "Progress.h"
#include "SvgPlot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace
{
const std::vector<std::string> Spaces = { "physical", "data" };
constexpr double LongestStep = 8.0, ShortestStep = 0.25; // voxels
constexpr double ShortestPostStep = 1.0 / 64.0;          // until post-classification is accurate
constexpr double ShortestPreStep = 1.0 / 16.0;           // until pre-integration is
constexpr double TableStep = 0.5;                        // voxels, while the table is what changes

using Curve = std::vector<BenchFrame>; // from long to short steps

std::string Number(const char* format, double value)
{
  char text[48];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string StepText(double step)
{
  return step < 1.0 ? "1/" + Number("%g", 1.0 / step) : Number("%g", step);
}

// What a frame needs whose error is the accepted one, on the line through the logarithms of the two frames
// around it.
struct Needed
{
  bool IsReached = false;
  double Seconds = 0.0;
  double Step = 0.0;
};

Needed AtError(const Curve& curve, double error)
{
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    const BenchFrame& good = curve[i];
    if (good.RootMeanSquare > error)
    {
      continue;
    }
    if (i == 0)
    {
      return { true, good.Seconds(), good.Step };
    }
    const BenchFrame& bad = curve[i - 1];
    const double share =
      std::log(bad.RootMeanSquare / error) / std::log(bad.RootMeanSquare / good.RootMeanSquare);
    return { true, bad.Seconds() * std::pow(good.Seconds() / bad.Seconds(), share),
      bad.Step * std::pow(good.Step / bad.Step, share) };
  }
  return { false, curve.back().Seconds(), curve.back().Step };
}

double LeastError(const Curve& curve)
{
  double least = curve.front().RootMeanSquare;
  for (const BenchFrame& frame : curve)
  {
    least = std::min(least, frame.RootMeanSquare);
  }
  return least;
}

struct Curves
{
  Curve Post, Pre, PreLarge;
};

const BenchTable SmallTable = { 256, 32 }, LargeTable = { 1024, 32 };

// Pairs at the steps of both, then post-classification alone until its error is accepted.
Curves MeasureSteps(IntegrationBench& bench, const BenchFunction& function, const std::string& space)
{
  Curves curves;
  for (double step = LongestStep; step >= ShortestStep; step *= 0.5)
  {
    const auto [post, pre] = bench.MeasurePair(function, space, step, SmallTable);
    curves.Post.push_back(post);
    curves.Pre.push_back(pre);
    curves.PreLarge.push_back(bench.Measure(function, space, "pre-integrated", step, LargeTable));
  }
  for (double step = 0.5 * ShortestStep;
       step >= ShortestPostStep && curves.Post.back().RootMeanSquare > AcceptedError; step *= 0.5)
  {
    curves.Post.push_back(bench.Measure(function, space, "post", step));
  }
  for (double step = 0.5 * ShortestStep;
       step >= ShortestPreStep && curves.PreLarge.back().RootMeanSquare > AcceptedError; step *= 0.5)
  {
    curves.PreLarge.push_back(bench.Measure(function, space, "pre-integrated", step, LargeTable));
  }
  return curves;
}

void Write(CsvWriter& csv, const BenchFunction& function, const std::string& space,
  const std::string& classification, const Curve& curve)
{
  for (const BenchFrame& frame : curve)
  {
    csv.Write(function.Name, space, classification, frame.Step, frame.FrameSeconds, frame.TableSeconds,
      frame.RootMeanSquare, frame.Maximum);
  }
}

PlotSeries Series(const std::string& name, const Curve& curve)
{
  PlotSeries series{ name, {} };
  for (const BenchFrame& frame : curve)
  {
    series.Points.push_back({ frame.Seconds(), frame.RootMeanSquare, StepText(frame.Step) });
  }
  return series;
}

// At the accepted error, or at the least one that both ways reach.
void PrintSpeed(const BenchFunction& function, const std::string& space, const Curves& curves)
{
  const double least = LeastError(curves.Post);
  const double error =
    std::max({ AcceptedError, least, std::min(LeastError(curves.Pre), LeastError(curves.PreLarge)) });
  const Needed post = AtError(curves.Post, error);
  const Needed small = AtError(curves.Pre, error), large = AtError(curves.PreLarge, error);
  const bool takesSmall = small.IsReached && (!large.IsReached || small.Seconds < large.Seconds);
  const Needed& pre = takesSmall ? small : large;
  std::printf("%s, %s space: least RMSE post-classified %.2g, pre-integrated %.2g; RMSE %.3g takes "
              "post-classification %.3g s (step %.3g voxels), pre-integration %.3g s with its table of %d "
              "entries (step "
              "%.3g): %.3g times as fast\n",
    function.Name.c_str(), space.c_str(), least,
    std::min(LeastError(curves.Pre), LeastError(curves.PreLarge)), error, post.Seconds, post.Step,
    pre.Seconds, (takesSmall ? SmallTable : LargeTable).Size, pre.Step, post.Seconds / pre.Seconds);
}

// Frames without the table: it is built once.
void PrintOverhead(const BenchFunction& function, const std::string& space, const Curves& curves)
{
  std::printf("%s, %s space: a pre-integrated frame over a post-classified one at the same step:",
    function.Name.c_str(), space.c_str());
  for (std::size_t i = 0; i < curves.Pre.size(); ++i)
  {
    std::printf(" %.2f (%s)", curves.Pre[i].FrameSeconds / curves.Post[i].FrameSeconds,
      StepText(curves.Pre[i].Step).c_str());
  }
  std::printf("\n");
}

void TradeSteps(IntegrationBench& bench, const std::string& folder)
{
  CsvWriter csv(folder + "/integration.csv",
    { "function", "space", "classification", "step", "frame seconds", "table seconds", "rmse", "maximum" });
  for (const BenchFunction& function : { SmoothFunction(), SpikyFunction(1.0 / 256.0) })
  {
    const std::string shape = function.Name.substr(0, function.Name.find(' '));
    Progress measuring("Step lengths, " + shape);
    Plot plot{ "Integration, " + shape + " transfer function: time against error, by step", "seconds",
      "RMSE of a picture in [0, 1]", {} };
    for (const std::string& space : Spaces)
    {
      const Curves curves = MeasureSteps(bench, function, space);
      const std::vector<std::pair<std::string, const Curve*>> named = { { "post", &curves.Post },
        { "pre-integrated 256", &curves.Pre }, { "pre-integrated 1024", &curves.PreLarge } };
      for (const auto& [classification, curve] : named)
      {
        Write(csv, function, space, classification, *curve);
        plot.Series.push_back(Series(classification + ", " + space, *curve));
      }
      PrintSpeed(function, space, curves);
      PrintOverhead(function, space, curves);
    }
    WriteSvg(folder + "/integration-" + shape + ".svg", plot);
  }
}

void TradeTables(IntegrationBench& bench, const std::string& folder)
{
  const Progress measuring("Table sizes and bits");
  CsvWriter csv(folder + "/integration-tables.csv",
    { "function", "space", "size", "bits", "table seconds", "terms' KiB", "frame seconds", "rmse",
      "maximum" });
  Plot plot{ "Pre-integrated tables: time to build one against error, by entries", "seconds",
    "RMSE of a picture in [0, 1]", {} };
  for (const BenchFunction& function : { SmoothFunction(), SpikyFunction(1.0 / 256.0) })
  {
    for (const std::string& space : Spaces)
    {
      for (const int bits : { 16, 32 })
      {
        PlotSeries series{ function.Name + ", " + space + ", " + std::to_string(bits) + " bits", {} };
        for (const int size : { 64, 256, 1024, 2048 })
        {
          const BenchFrame frame =
            bench.Measure(function, space, "pre-integrated", TableStep, { size, bits });
          csv.Write(function.Name, space, size, bits, frame.TableSeconds, frame.TableKiB, frame.FrameSeconds,
            frame.RootMeanSquare, frame.Maximum);
          series.Points.push_back({ frame.TableSeconds, frame.RootMeanSquare, std::to_string(size) });
        }
        plot.Series.push_back(series);
      }
    }
  }
  WriteSvg(folder + "/integration-tables.svg", plot);
}

// [Kraus2005] section 3.2.4: the longest step of an accepted error, as the function's triangles get thinner.
void TradeRate(IntegrationBench& bench, const std::string& folder)
{
  const Progress measuring("Sampling rates");
  CsvWriter csv(folder + "/integration-rate.csv", { "function", "classification", "step", "is reached" });
  Plot plot{ "Longest step of RMSE 1/255 in data space, by the width of the triangles", "width",
    "step in voxels", { { "post", {} }, { "pre-integrated", {} } } };
  for (const double width : { 1.0 / 32.0, 1.0 / 64.0, 1.0 / 128.0, 1.0 / 256.0 })
  {
    const BenchFunction function = SpikyFunction(width);
    for (PlotSeries& series : plot.Series)
    {
      Curve curve;
      const double shortest = series.Name == "post" ? ShortestPostStep : ShortestPreStep;
      for (double step = LongestStep; step >= shortest; step *= 0.5)
      {
        curve.push_back(bench.Measure(function, "data", series.Name, step, LargeTable));
        if (curve.back().RootMeanSquare < AcceptedError)
        {
          break;
        }
      }
      const Needed needed = AtError(curve, AcceptedError);
      csv.Write(function.Name, series.Name, needed.Step, needed.IsReached ? "yes" : "no");
      series.Points.push_back({ width, needed.Step, Number("%.2g", needed.Step) });
      std::printf("%s, data space, %s: RMSE 1/255 at %.3g voxels%s\n", function.Name.c_str(),
        series.Name.c_str(), needed.Step, needed.IsReached ? "" : " not reached");
    }
  }
  WriteSvg(folder + "/integration-rate.svg", plot);
}
}

void TradeIntegration(const IntegrationTradeOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  IntegrationBench bench(options.Size, options.Headless);
  std::printf("Times are %s.\n",
    bench.IsSoftware() ? "the processor's, of all threads: frames are drawn by it" : "the clock's");
  TradeSteps(bench, options.Folder);
  TradeTables(bench, options.Folder);
  TradeRate(bench, options.Folder);
  Progress::Say(options.Folder + "/integration*.csv and integration*.svg written");
}
