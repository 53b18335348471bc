// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeVisibility.h"

#include "CsvWriter.h"
#include "Progress.h"
#include "SvgPlot.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace
{
using reference::SweepAlgorithm;
using reference::SweepSettings;

const std::vector<double> Angles = { 30.0, 60.0, 80.0 };
constexpr double MiddleAngle = 60.0;
const std::vector<int> GridSizes = { 32, 64, 128, 256 };
const std::vector<double> SliceDistances = { 4.0, 2.0, 1.0, 0.5 };

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

struct NamedAlgorithm
{
  std::string Name;
  SweepSettings Settings;
};

// By the mapper's way without gathering unless named otherwise.
NamedAlgorithm Directions(int count)
{
  NamedAlgorithm result;
  result.Settings.samples = count;
  result.Settings.own = reference::OwnOpacity::AlongRay;
  result.Name = "sweep " + std::to_string(count);
  return result;
}

NamedAlgorithm Gathered(int directions)
{
  NamedAlgorithm result = Directions(directions);
  result.Settings.own = reference::OwnOpacity::Gathered;
  result.Settings.axis = reference::SweepAxis::Pixel;
  result.Name = "gathered " + std::to_string(directions);
  return result;
}

NamedAlgorithm DirectionsAboutTheEye()
{
  NamedAlgorithm result = Directions(8);
  result.Settings.axis = reference::SweepAxis::Eye;
  result.Name += " about the eye";
  return result;
}

NamedAlgorithm DirectionsByHalfSlices()
{
  NamedAlgorithm result = Directions(8);
  result.Settings.own = reference::OwnOpacity::HalfSlice;
  result.Name += " with half slices";
  return result;
}

NamedAlgorithm Disk(const std::string& name, SweepAlgorithm algorithm, int size = 5)
{
  NamedAlgorithm result;
  result.Name = name + " " + std::to_string(size) + " x " + std::to_string(size);
  result.Settings.algorithm = algorithm;
  result.Settings.samples = size;
  result.Settings.own = reference::OwnOpacity::AlongRay;
  return result;
}

// As in the paper's Algorithm 1: a sample is shaded before its own slice counts.
NamedAlgorithm PublishedDisk()
{
  NamedAlgorithm result = Disk("disk as published", SweepAlgorithm::Disk);
  result.Settings.own = reference::OwnOpacity::None;
  result.Settings.axis = reference::SweepAxis::Eye;
  return result;
}

NamedAlgorithm ApproximatedDisk()
{
  NamedAlgorithm result = Disk("disk with approximated distances", SweepAlgorithm::Disk);
  result.Settings.trueDistances = false;
  return result;
}

std::vector<NamedAlgorithm> Algorithms()
{
  return { Gathered(4), Gathered(8), Gathered(16), Directions(4), Directions(8), Directions(16),
    DirectionsByHalfSlices(), DirectionsAboutTheEye(), Disk("disk", SweepAlgorithm::Disk),
    Disk("disk by solid angle", SweepAlgorithm::DiskBySolidAngle), ApproximatedDisk(), PublishedDisk() };
}

// log(error) by log(length) between the finest two of a knob.
double Slope(double finerError, double coarserError, double ratioOfLengths)
{
  return std::log(coarserError / finerError) / std::log(ratioOfLengths);
}

class AlgorithmTable
{
public:
  AlgorithmTable(VisibilityBench& bench, const std::string& folder)
    : Bench(bench)
    , Csv(folder + "/visibility-algorithms.csv",
        { "algorithm", "angle", "froxels", "slice distance", "mean of samples", "rms of samples",
          "maximum of samples", "bias", "mean of pixels", "maximum of pixels" })
  {
  }

  VisibilityBench::AlgorithmError Add(
    const NamedAlgorithm& algorithm, double angle, int size, double sliceDistance)
  {
    const auto error = this->Bench.JudgeAlgorithm(angle, size, sliceDistance, algorithm.Settings);
    this->Write(algorithm.Name, angle, size, sliceDistance, error);
    return error;
  }

  void Write(const std::string& name, double angle, int size, double sliceDistance,
    const VisibilityBench::AlgorithmError& error)
  {
    this->Csv.Write(name, angle, size, sliceDistance, error.Samples.mean, error.Samples.rootMeanSquare,
      error.Samples.maximum, error.Samples.bias, error.Pixels.Mean, error.Pixels.Maximum);
  }

private:
  VisibilityBench& Bench;
  CsvWriter Csv;
};

void PrintError(const std::string& what, const VisibilityBench::AlgorithmError& error)
{
  std::printf("%s: samples %.4f on average, %.4f rms, bias %+.4f; pixels %.4f, at most %.3f\n", what.c_str(),
    error.Samples.mean, error.Samples.rootMeanSquare, error.Samples.bias, error.Pixels.Mean,
    error.Pixels.Maximum);
}

// In double: what the algorithms themselves are off by, without any GPU.
void TradeAlgorithms(VisibilityBench& bench, const std::string& folder)
{
  const Progress measuring("Algorithms in double");
  AlgorithmTable table(bench, folder);
  for (const double angle : Angles)
  {
    const std::string degrees = Number(angle) + " degrees, ";
    const auto noise = bench.NoiseOfTruth(angle), axis = bench.AxisOfCone(angle);
    table.Write("noise of the truth", angle, 0, 0.0, noise);
    table.Write("rays about the slices' normal", angle, 0, 0.0, axis);
    PrintError(degrees + "noise of the truth", noise);
    PrintError(degrees + "cone about the slices' normal", axis);
  }
  Plot plot{ "Algorithms in double: error of the samples' visibility by the froxels' side",
    "side, of the grid", "mean absolute error", {} };
  for (const NamedAlgorithm& algorithm : Algorithms())
  {
    PlotSeries series{ algorithm.Name, {} };
    std::vector<double> bySize, byDistance;
    for (const int size : GridSizes)
    {
      bySize.push_back(table.Add(algorithm, MiddleAngle, size, 1.0).Samples.mean);
      series.Points.push_back({ 1.0 / size, bySize.back(), std::to_string(size) });
    }
    for (const double distance : SliceDistances)
    {
      byDistance.push_back(table.Add(algorithm, MiddleAngle, 64, distance).Samples.mean);
    }
    for (const double angle : { 30.0, 80.0 })
    {
      table.Add(algorithm, angle, 128, 1.0);
    }
    std::printf(
      "%s: mean error as the froxels' side to the power %.2f (64 to 256), as the slice distance to the "
      "power %.2f (1/2 to 2 of 1/64)\n",
      algorithm.Name.c_str(), Slope(bySize[3], bySize[1], 4.0), Slope(byDistance[3], byDistance[1], 4.0));
    plot.Series.push_back(series);
  }
  WriteSvg(folder + "/visibility-algorithms.svg", plot);
}

struct Setting
{
  std::string Knob, Value;
  double Angle = MiddleAngle;
  VisibilityKnobs Knobs;
};

template <class Type>
void AddKnob(std::vector<Setting>& settings, const std::string& knob, const std::vector<Type>& values,
  Type VisibilityKnobs::*member)
{
  for (const Type& value : values)
  {
    Setting setting{ knob, Number(value), MiddleAngle, {} };
    setting.Knobs.*member = value;
    settings.push_back(setting);
  }
}

std::vector<Setting> Settings()
{
  std::vector<Setting> settings;
  AddKnob(settings, "grid size", GridSizes, &VisibilityKnobs::GridSize);
  AddKnob(settings, "slice distance", SliceDistances, &VisibilityKnobs::SliceDistance);
  AddKnob(settings, "directions", { 4, 8, 16 }, &VisibilityKnobs::Samples);
  AddKnob(settings, "gather samples", { 0, 2, 3, 4, 6, 8 }, &VisibilityKnobs::GatherSamples);
  AddKnob(settings, "bits", { 8, 16, 32 }, &VisibilityKnobs::Precision);
  for (const std::string algorithm : { "disk", "disk-solid-angle" })
  {
    for (const int size : { 2, 5, 13 })
    {
      Setting setting{ algorithm, Number(size), MiddleAngle, {} };
      setting.Knobs.Algorithm = algorithm;
      setting.Knobs.DiskSize = size;
      settings.push_back(setting);
    }
  }
  for (const double angle : { 0.0, 30.0, 60.0, 80.0 })
  {
    settings.push_back({ "angle", Number(angle), angle, {} });
  }
  for (const std::string quality : { "draft", "balanced", "reference" })
  {
    for (const double angle : Angles)
    {
      Setting setting{ quality, Number(angle), angle, {} };
      setting.Knobs.Quality = quality;
      settings.push_back(setting);
    }
  }
  return settings;
}

// What frames are timed with; the first is that of the plot. Presets are timed with all of them.
const FrameKind Kinds[] = { { true, false }, { false, false }, { true, true }, { false, true } };

std::string Name(const FrameKind& kind)
{
  return std::string(kind.IsLit ? "lit" : "unlit") + (kind.SkipsEmptySpace ? ", skipping" : "");
}

class FrameTable
{
public:
  explicit FrameTable(const std::string& folder)
    : Csv(folder + "/visibility.csv",
        { "knob", "value", "angle", "mean error", "maximum error", "frame", "seconds", "seconds without",
          "ratio", "terms' KiB" })
  {
  }

  void Add(const Setting& setting, const PictureError& error, const FrameKind& kind, const FrameCost& cost)
  {
    this->Csv.Write(setting.Knob, setting.Value, setting.Angle, error.Mean, error.Maximum, Name(kind),
      cost.Seconds, cost.SecondsWithout, cost.Ratio(), cost.KiB);
    std::printf("%s %s, %g degrees: error %.4f, at most %.3f; %s frame %.3g s, without %.3g s: %.2f times\n",
      setting.Knob.c_str(), setting.Value.c_str(), setting.Angle, error.Mean, error.Maximum,
      Name(kind).c_str(), cost.Seconds, cost.SecondsWithout, cost.Ratio());
  }

private:
  CsvWriter Csv;
};

void TradeFrames(VisibilityBench& bench, const std::string& folder)
{
  const Progress measuring("Frames");
  FrameTable table(folder);
  Plot plot{ "Occlusion: time of a frame over that without it, against error", "frame over that without",
    "mean absolute error", {} };
  for (const Setting& setting : Settings())
  {
    const PictureError error = bench.Judge(setting.Angle, setting.Knobs);
    const int kinds = setting.Knobs.Quality == "custom" ? 1 : static_cast<int>(std::size(Kinds));
    for (int kind = 0; kind < kinds; ++kind)
    {
      const FrameCost cost = bench.Time(setting.Angle, setting.Knobs, Kinds[kind]);
      table.Add(setting, error, Kinds[kind], cost);
      if (kind > 0)
      {
        continue;
      }
      if (plot.Series.empty() || plot.Series.back().Name != setting.Knob)
      {
        plot.Series.push_back({ setting.Knob, {} });
      }
      plot.Series.back().Points.push_back({ cost.Ratio(), error.Mean, setting.Value });
    }
  }
  WriteSvg(folder + "/visibility.svg", plot);
}
}

void TradeVisibility(const VisibilityTradeOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  VisibilityBench bench(options);
  std::printf("Times are %s.\n",
    bench.IsSoftware() ? "the processor's, of all threads: frames are drawn by it" : "the clock's");
  if (options.Part != "frames")
  {
    TradeAlgorithms(bench, options.Folder);
  }
  if (options.Part != "algorithms")
  {
    TradeFrames(bench, options.Folder);
  }
  Progress::Say(options.Folder + "/visibility*.csv and visibility*.svg written");
}
