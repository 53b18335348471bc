// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeLines.h"

#include "CsvWriter.h"
#include "FramePicture.h"
#include "LineScene.h"
#include "LineTubes.h"
#include "Progress.h"
#include "SvgPlot.h"

#include "vtkAnalyticLineSource.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>

namespace
{
// Beside the knob that is turned.
struct Setting
{
  std::string Knob, Value;
  LineSettings Lines;
  int Directions = 0; // of the sampled projection
  bool PerBlock = false;
};

LineSettings Spirals(double radius)
{
  LineSettings lines;
  lines.Radius = radius;
  lines.Color[1] = 0.35;
  lines.Color[2] = 0.2;
  return lines;
}

std::vector<Setting> Settings(double radius)
{
  std::vector<Setting> settings;
  for (int grid : { 64, 128, 192, 256, 384 })
  {
    settings.push_back({ "grid", std::to_string(grid), Spirals(radius) });
    settings.back().Lines.Grid = grid;
  }
  for (int order : { 0, 2, 4, 8, 12 })
  {
    settings.push_back({ "order", std::to_string(order), Spirals(radius) });
    settings.back().Lines.Order = order;
  }
  for (const char* tolerance : { "0", "1e-5", "1e-4", "1e-3", "1e-2" })
  {
    settings.push_back({ "tolerance", tolerance, Spirals(radius) });
    settings.back().Lines.Tolerance = std::stod(tolerance);
  }
  for (int directions : { 0, 128, 512 })
  {
    settings.push_back({ "projection", directions == 0 ? "analytic" : std::to_string(directions),
      Spirals(radius), directions });
  }
  settings.push_back({ "opacity", "thin lines", Spirals(radius) });
  settings.back().Lines.ExactProduct = false;
  settings.push_back({ "view directions", "per block", Spirals(radius), 0, true });
  return settings;
}

double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

PictureSettings MakePicture(int size)
{
  PictureSettings picture;
  picture.Size = { size, size };
  picture.Background = { 0.0, 0.0, 0.0 };
  picture.Camera.Azimuth = 25.0;
  picture.Camera.Elevation = 30.0;
  picture.Camera.Zoom = 1.3;
  return picture;
}

struct Result
{
  FramePicture Frame;
  double VoxelizeSeconds = 0.0, EvaluateSeconds = 0.0, MiB = 0.0;
};

vtkSmartPointer<vtkImageData> Voxelize(vtkPolyData* lines, const Setting& setting)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  SetUpVoxelizer(setting.Lines, LightSettings(), lines->GetBounds(), voxelizer);
  voxelizer->SetInputData(lines);
  if (setting.Directions > 0)
  {
    voxelizer->SetProjectionToSampled();
    voxelizer->SetNumberOfDirections(setting.Directions);
  }
  voxelizer->Update();
  return voxelizer->GetOutput();
}

Result Measure(vtkPolyData* lines, const Setting& setting, const LinesTradeOptions& options)
{
  Result result;
  double start = ProcessorSeconds();
  const vtkSmartPointer<vtkImageData> voxels = Voxelize(lines, setting);
  result.VoxelizeSeconds = ProcessorSeconds() - start;
  result.MiB = voxels->GetActualMemorySize() / 1024.0;
  LineScene scene(voxels, MakePicture(options.Size), OffScreenWindow(options.Headless));
  scene.GetEvaluator()->SetViewDirections(setting.PerBlock);
  start = ProcessorSeconds();
  scene.GetEvaluator()->Update();
  result.EvaluateSeconds = ProcessorSeconds() - start;
  scene.Render();
  result.Frame = ToFramePicture(scene.GetScene().Capture());
  return result;
}
}

void TradeLines(const LinesTradeOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(options.Segments);
  source->Update();
  vtkPolyData* lines = source->GetOutput();
  Setting first{ "", "", Spirals(options.Radius) };
  FramePicture truth;
  {
    const Progress tubes("Drawing tubes at 10 x 10 the resolution");
    LineScene scene(Voxelize(lines, first), MakePicture(options.Size), OffScreenWindow(options.Headless));
    truth = DrawTubes(lines, Spirals(options.Radius), scene.GetScene()).Frame;
  }
  WritePng(truth, options.Folder + "/lines-tubes.png");
  const FramePicture smallTruth = Reduced(truth, 2);
  CsvWriter csv(options.Folder + "/lines.csv",
    { "knob", "value", "voxelize s", "evaluate s", "MiB", "PSNR dB", "PSNR of 2 x 2 dB" });
  Plot plot{ "Spirals against tubes", "MiB", "PSNR of 2 x 2, dB", {} };
  plot.LogarithmicY = false;
  Progress measuring("Measuring");
  for (const Setting& setting : Settings(options.Radius))
  {
    if (!options.Knob.empty() && setting.Knob != options.Knob)
    {
      continue;
    }
    const Result result = Measure(lines, setting, options);
    const double raw = SignalToNoise(truth, result.Frame);
    const double reduced = SignalToNoise(smallTruth, Reduced(result.Frame, 2));
    csv.Write(
      setting.Knob, setting.Value, result.VoxelizeSeconds, result.EvaluateSeconds, result.MiB, raw, reduced);
    measuring.Line(setting.Knob + " " + setting.Value);
    if (plot.Series.empty() || plot.Series.back().Name != setting.Knob)
    {
      plot.Series.push_back({ setting.Knob, {} });
    }
    plot.Series.back().Points.push_back({ result.MiB, reduced, setting.Value });
    if (setting.Knob == "grid" && setting.Value == "256")
    {
      WritePng(result.Frame, options.Folder + "/lines-voxels.png");
    }
  }
  WriteSvg(options.Folder + "/lines.svg", plot);
}
