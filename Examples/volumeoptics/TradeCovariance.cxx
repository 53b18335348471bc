// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeCovariance.h"

#include "CsvWriter.h"
#include "FrameError.h"
#include "GalleryField.h"
#include "Progress.h"
#include "SvgPlot.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkSobelNormalFilter.h"

#include <vtkNew.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace
{
struct Setting
{
  std::string Knob; // which one is turned, and its value
  std::string Value;
  int Pattern = vtkAmbientCovarianceFilter::Shared;
  int Samples = 100;
  double Radius = 10.0;
  double ResolutionFactor = 1.0;
  int Storage = vtkAnisotropyFilter::Map;
  int Bits = 32;
  int Interpolation = vtkAmbientCovarianceFilter::Nearest;
};

struct Outcome
{
  Setting With;
  double Seconds = 0.0;
  FrameError Error;
};

std::string Text(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%g", number);
  return text;
}

template <class Change>
Setting With(const Setting& base, const std::string& knob, const std::string& value, Change change)
{
  Setting setting = base;
  setting.Knob = knob;
  setting.Value = value;
  change(setting);
  return setting;
}

void AddPatterns(std::vector<Setting>& settings, const Setting& base)
{
  const std::pair<const char*, int> patterns[] = { { "shared", vtkAmbientCovarianceFilter::Shared },
    { "per block", vtkAmbientCovarianceFilter::PerBlock },
    { "per voxel", vtkAmbientCovarianceFilter::PerVoxel } };
  for (const auto& pattern : patterns)
  {
    for (const int samples : { 10, 25, 50, 100, 200, 400, 800 })
    {
      // Algorithm 1 to the letter is slow: its curve needs no more than these.
      if (pattern.second == vtkAmbientCovarianceFilter::PerVoxel && samples > 200)
      {
        continue;
      }
      settings.push_back(
        With(base, std::string("n, ") + pattern.first, std::to_string(samples), [&](Setting& s) {
          s.Pattern = pattern.second;
          s.Samples = samples;
        }));
    }
  }
  for (const int samples : { 25, 100, 400 })
  {
    settings.push_back(With(base, "n, shared, linear", std::to_string(samples), [&](Setting& s) {
      s.Samples = samples;
      s.Interpolation = vtkAmbientCovarianceFilter::Linear;
    }));
  }
}

// One knob after the other, from the base.
std::vector<Setting> Settings(double radius)
{
  Setting base;
  base.Radius = radius;
  std::vector<Setting> settings;
  AddPatterns(settings, base);
  for (const double share : { 0.3, 0.5, 0.7, 1.5 })
  {
    const double value = std::max(share * radius, 1.0);
    settings.push_back(With(base, "radius", Text(value), [&](Setting& s) { s.Radius = value; }));
  }
  for (const double factor : { 0.25, 0.5, 0.75, 1.0 })
  {
    settings.push_back(
      With(base, "grid factor", Text(factor), [&](Setting& s) { s.ResolutionFactor = factor; }));
  }
  const std::pair<const char*, int> storages[] = { { "map", vtkAnisotropyFilter::Map },
    { "components", vtkAnisotropyFilter::Components }, { "world", vtkAnisotropyFilter::World } };
  for (const auto& storage : storages)
  {
    for (const int bits : { 8, 16, 32 })
    {
      settings.push_back(
        With(base, std::string("bits, ") + storage.first, std::to_string(bits), [&](Setting& s) {
          s.Storage = storage.second;
          s.Bits = bits;
          s.Pattern = vtkAmbientCovarianceFilter::Exhaustive;
        }));
    }
  }
  return settings;
}

vtkSmartPointer<vtkImageData> Normals(vtkImageData* image, double factor)
{
  vtkNew<vtkSobelNormalFilter> filter;
  filter->SetInputData(image);
  filter->SetResolutionFactor(factor);
  filter->Update();
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
}

FrameImage Estimate(vtkImageData* image, const Setting& setting, double tolerance, double& seconds)
{
  FrameImage frames;
  frames.Normals = Normals(image, setting.ResolutionFactor);
  frames.Storage = setting.Storage;
  vtkNew<vtkAmbientCovarianceFilter> filter;
  filter->SetInputData(image);
  filter->SetNormalsData(frames.Normals);
  filter->SetRadius(setting.Radius);
  filter->SetScalarTolerance(tolerance);
  filter->SetScalarRange(image->GetScalarRange());
  filter->SetNumberOfSamples(setting.Samples);
  filter->SetSamplingPattern(setting.Pattern);
  filter->SetSampleInterpolation(setting.Interpolation);
  filter->SetStorage(setting.Storage);
  filter->SetResolutionFactor(setting.ResolutionFactor);
  filter->SetOutputPrecision(setting.Bits);
  const double start = vtkTimerLog::GetUniversalTime();
  filter->Update();
  seconds = vtkTimerLog::GetUniversalTime() - start;
  frames.Code = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  return frames;
}

// All voxels of the ball, in the form that has neither a pole nor the normal's sign.
FrameImage Truth(vtkImageData* image, const CovarianceTradeOptions& options, double& seconds)
{
  Setting setting;
  setting.Radius = options.Radius;
  setting.Pattern = vtkAmbientCovarianceFilter::Exhaustive;
  setting.Storage = vtkAnisotropyFilter::World;
  return Estimate(image, setting, options.Tolerance, seconds);
}

void WriteTable(const std::string& path, const std::vector<Outcome>& outcomes, double exhaustiveSeconds)
{
  CsvWriter csv(path,
    { "knob", "value", "seconds", "mean_angle_degrees", "fraction_above_10_degrees", "strength_rms",
      "exhaustive_seconds" });
  for (const Outcome& outcome : outcomes)
  {
    csv.Write(outcome.With.Knob, outcome.With.Value, outcome.Seconds, outcome.Error.MeanAngle,
      outcome.Error.BadFraction, outcome.Error.StrengthRms, exhaustiveSeconds);
  }
}

void WritePlots(const std::string& folder, const std::vector<Outcome>& outcomes)
{
  Plot time{ "Covariance: time against error", "seconds", "mean error of the major axis, degrees", {} };
  Plot poles{ "Storage: error by the normal's direction", "|n.z|", "mean error of the major axis, degrees",
    {}, false, true };
  CsvWriter csv(folder + "/covariance-poles.csv", { "storage", "abs_nz", "mean_angle_degrees" });
  std::map<std::string, std::size_t> index;
  for (const Outcome& outcome : outcomes)
  {
    const bool isStorage = outcome.With.Knob.rfind("bits", 0) == 0;
    if (!isStorage)
    {
      const auto at = index.emplace(outcome.With.Knob, time.Series.size());
      if (at.second)
      {
        time.Series.push_back({ outcome.With.Knob, {} });
      }
      time.Series[at.first->second].Points.push_back(
        { outcome.Seconds, outcome.Error.MeanAngle, outcome.With.Value });
      continue;
    }
    PlotSeries series{ outcome.With.Knob.substr(6) + ", " + outcome.With.Value + " bits", {} };
    for (int bin = 0; bin < FrameError::NumberOfBins; ++bin)
    {
      const double center = (bin + 0.5) / FrameError::NumberOfBins;
      series.Points.push_back({ center, outcome.Error.AngleByPole[bin], "" });
      csv.Write(series.Name, center, outcome.Error.AngleByPole[bin]);
    }
    poles.Series.push_back(series);
  }
  WriteSvg(folder + "/covariance.svg", time);
  WriteSvg(folder + "/covariance-poles.svg", poles);
}
}

void TradeCovariance(const CovarianceTradeOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  const Volume volume = options.File.empty() ? GalleryField(options.Field, "") : ReadVolume(options.File);
  double exhaustiveSeconds = 0.0;
  FrameImage truth;
  {
    const Progress exhaustive("Exhaustive ball, the truth");
    truth = Truth(volume.Image, options, exhaustiveSeconds);
  }
  const std::vector<Setting> settings = Settings(options.Radius);
  std::vector<Outcome> outcomes;
  Progress trading("Settings");
  for (const Setting& setting : settings)
  {
    Outcome outcome;
    outcome.With = setting;
    const FrameImage estimate = Estimate(volume.Image, setting, options.Tolerance, outcome.Seconds);
    outcome.Error = CompareFrames(estimate, truth);
    outcomes.push_back(outcome);
    trading.Update(
      static_cast<double>(outcomes.size()) / settings.size(), setting.Knob + " " + setting.Value);
  }
  WriteTable(options.Folder + "/covariance.csv", outcomes, exhaustiveSeconds);
  WritePlots(options.Folder, outcomes);
  Progress::Say(options.Folder + "/covariance.csv and covariance.svg written");
}
