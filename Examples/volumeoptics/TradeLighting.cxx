// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeLighting.h"

#include "CsvWriter.h"
#include "GalleryField.h"
#include "Progress.h"
#include "SvgPlot.h"
#include "VolumeScene.h"

#include "RayCaster.h"
#include "vtkOpticsVolumeMapper.h"

#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

namespace
{
const char* const Function = R"({ "Boundaries": [ { "RangeA": [-1, 0.3], "RangeB": [0.55, 2],
  "Softness": 0.1, "Ambient": 0.1, "Diffuse": 0.7, "Specular": 0.5 } ] })";

// Beside the knob that is turned, everything is at its finest.
struct Setting
{
  std::string Knob, Value;
  double Step = 0.25;
  double StepLength = 1.0;
  int TableSize = 1024;
  int Precision = 32;
  int Gradient = vtkOpticsVolumeMapper::CentralDifferences;
  int Samples = vtkOpticsVolumeMapper::Fetched;
};

void AddGradientSteps(std::vector<Setting>& settings)
{
  for (const bool isFetched : { true, false })
  {
    for (const char* length : { "0.25", "0.5", "1", "2", "4" })
    {
      Setting setting{ isFetched ? "step h, fetched" : "step h, extrapolated", length };
      setting.StepLength = std::stod(length);
      setting.Samples = isFetched ? vtkOpticsVolumeMapper::Fetched : vtkOpticsVolumeMapper::Extrapolated;
      settings.push_back(setting);
    }
  }
}

void AddFetches(std::vector<Setting>& settings)
{
  const struct
  {
    const char* Name;
    int Gradient, Samples;
  } ways[] = { { "6 + 2: on the fly, fetched", vtkOpticsVolumeMapper::CentralDifferences,
                 vtkOpticsVolumeMapper::Fetched },
    { "6: on the fly, extrapolated", vtkOpticsVolumeMapper::CentralDifferences,
      vtkOpticsVolumeMapper::Extrapolated },
    { "1 + 2: stored, fetched", vtkOpticsVolumeMapper::Stored, vtkOpticsVolumeMapper::Fetched },
    { "1: stored, extrapolated", vtkOpticsVolumeMapper::Stored, vtkOpticsVolumeMapper::Extrapolated } };
  for (const auto& way : ways)
  {
    Setting setting{ "extra fetches", way.Name };
    setting.Gradient = way.Gradient;
    setting.Samples = way.Samples;
    settings.push_back(setting);
  }
}

std::vector<Setting> Settings()
{
  std::vector<Setting> settings;
  AddGradientSteps(settings);
  for (const char* size : { "8", "16", "32", "64", "128", "256", "512", "1024" })
  {
    Setting setting{ "table size", size };
    setting.TableSize = std::stoi(size);
    settings.push_back(setting);
  }
  for (const char* bits : { "16", "32" })
  {
    Setting setting{ "bits", bits };
    setting.Precision = std::stoi(bits);
    settings.push_back(setting);
  }
  AddFetches(settings);
  for (const char* step : { "2", "1", "0.5", "0.25", "0.125" })
  {
    settings.push_back({ "step length", step, std::stod(step) });
  }
  return settings;
}

PictureSettings Picture(const LightingTradeOptions& options)
{
  PictureSettings picture;
  picture.Function.Opacity = { { 0.1, 0.0 }, { 0.6, 0.1 }, { 10.0, 0.1 } };
  picture.Function.Color = { { 0.5, 0.45, 0.6, 0.72 } };
  picture.Lighting.Function = Function;
  picture.Lighting.Scale = 2.0;
  picture.Ambient.Precision = 16;
  picture.Camera = { 30.0, 15.0, 0.0, 1.3, {}, {}, {} };
  picture.Lights = { { -20.0, 25.0, 1.0 } };
  picture.Size = { options.Size, options.Size };
  picture.Background = { 0.0, 0.0, 0.0 };
  return picture;
}

// The scene as it stands, by a fine step.
reference::Image Truth(VolumeScene& scene, const PictureSettings& picture)
{
  auto* volume = vtkVolume::SafeDownCast(scene.GetRenderer()->GetVolumes()->GetItemAsObject(0));
  reference::Scene exact =
    reference::SceneFromVTK(scene.GetRenderer(), volume, picture.Size[0], picture.Size[1]);
  exact.step = 1.0 / 8.0;
  return reference::Render(exact);
}

// Processor time, which other programs disturb least; a software rasteriser's is all of the frame.
double MedianFrame(VolumeScene& scene)
{
  double seconds[5];
  for (double& time : seconds)
  {
    const std::clock_t begin = std::clock();
    scene.Render();
    time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
  std::sort(seconds, seconds + 5);
  return seconds[2];
}

void Apply(const Setting& setting, PictureSettings& picture, VolumeScene& scene)
{
  picture.Step = setting.Step;
  picture.Lighting.StepLength = setting.StepLength;
  scene.GetMapper()->SetLightingTableSize(setting.TableSize);
  scene.GetMapper()->SetTablePrecision(setting.Precision);
  scene.GetMapper()->SetScalarGradient(setting.Gradient);
  scene.GetMapper()->SetLightingSamples(setting.Samples);
  scene.Apply(picture);
  scene.Render();
}
}

void TradeLighting(const LightingTradeOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  const Volume volume = GalleryField(options.Field, "");
  VolumeScene scene(volume, OffScreenWindow(options.Headless));
  PictureSettings picture = Picture(options);
  scene.GetMapper()->SetMaxMemoryInBytes(vtkIdType(1) << 31); // no knob is turned by a lack of memory
  CsvWriter csv(options.Folder + "/lighting.csv", { "knob", "value", "seconds", "rmse", "maximum" });
  Plot plot{ "Lighting transfer function: time of a frame against error", "seconds",
    "RMSE of a picture in [0, 1]", {} };
  double lengthOfTruth = 0.0;
  reference::Image truth;
  for (const Setting& setting : Settings())
  {
    Apply(setting, picture, scene);
    if (setting.StepLength != lengthOfTruth)
    {
      truth = Truth(scene, picture); // another step h is another picture
      lengthOfTruth = setting.StepLength;
    }
    const double seconds = MedianFrame(scene);
    const reference::Difference error = reference::Compare(truth, scene.Capture());
    csv.Write(setting.Knob, setting.Value, seconds, error.rootMeanSquare, error.maximum);
    if (plot.Series.empty() || plot.Series.back().Name != setting.Knob)
    {
      plot.Series.push_back({ setting.Knob, {} });
    }
    plot.Series.back().Points.push_back({ seconds, error.rootMeanSquare, setting.Value });
  }
  WriteSvg(options.Folder + "/lighting.svg", plot);
  Progress::Say(options.Folder + "/lighting.csv and lighting.svg written");
}
