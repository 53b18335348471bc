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
#include "vtkOpticsVolumeMapper.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

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
  LineRenderer Renderer = LineRenderer::Mapper;
  bool PerBlock = false;
  int Bits = 16;
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
  settings.push_back({ "opacity", "product", Spirals(radius) });
  settings.push_back({ "opacity", "thin lines", Spirals(radius) });
  settings.back().Lines.ExactProduct = false;
  for (int bits : { 8, 16, 32 })
  {
    settings.push_back({ "storage", std::to_string(bits) + " bits", Spirals(radius) });
    settings.back().Bits = bits;
  }
  settings.push_back({ "evaluation", "mapper, per voxel", Spirals(radius) });
  settings.push_back({ "evaluation", "filter, per voxel", Spirals(radius), 0, LineRenderer::Evaluator });
  settings.push_back(
    { "evaluation", "filter, per block", Spirals(radius), 0, LineRenderer::Evaluator, true });
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
  double VoxelizeSeconds = 0.0, FrameSeconds = 0.0;
  double VoxelMiB = 0.0, MapperMiB = 0.0;
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

Result Measure(vtkPolyData* lines, const Setting& setting, vtkCamera* view, const LinesTradeOptions& options)
{
  Result result;
  double start = ProcessorSeconds();
  const vtkSmartPointer<vtkImageData> voxels = Voxelize(lines, setting);
  result.VoxelizeSeconds = ProcessorSeconds() - start;
  result.VoxelMiB = voxels->GetActualMemorySize() / 1024.0;
  LineScene scene(voxels, MakePicture(options.Size), OffScreenWindow(options.Headless), setting.Renderer);
  scene.GetEvaluator()->SetViewDirections(setting.PerBlock);
  scene.GetScene().GetMapper()->SetLinePrecision(setting.Bits);
  vtkCamera* camera = scene.GetScene().GetRenderer()->GetActiveCamera();
  camera->DeepCopy(view);
  camera->Azimuth(1.0);
  scene.Render(); // compiles, uploads
  camera->Azimuth(-1.0);
  start = ProcessorSeconds();
  scene.Render();
  result.FrameSeconds = ProcessorSeconds() - start;
  result.MapperMiB = static_cast<double>(scene.GetScene().GetMapper()->GetTermMemorySize()) / 1024.0;
  result.Frame = ToFramePicture(scene.GetScene().Capture());
  return result;
}

// The error that a ratio of signal to noise, in dB, stands for, of pixels in [0, 1].
void AddPoint(Plot& plot, const Setting& setting, double x, double decibels)
{
  if (plot.Series.empty() || plot.Series.back().Name != setting.Knob)
  {
    plot.Series.push_back({ setting.Knob, {} });
  }
  plot.Series.back().Points.push_back({ x, std::pow(10.0, -decibels / 20.0), setting.Value });
}

// Of the lines and of their voxels, as figure 8 of [Schussman2004].
void TradeStorage(const LinesTradeOptions& options)
{
  CsvWriter csv(options.Folder + "/lines-storage.csv",
    { "segments", "MiB of lines", "voxelize s", "MiB, order 2", "MiB, order 4", "MiB, order 8" });
  Plot plot{ "Storage of lines and of voxels, 256 along the longest side", "segments", "MiB",
    { { "lines", {} }, { "order 2", {} }, { "order 4", {} }, { "order 8", {} } } };
  Progress measuring("Measuring storage");
  for (int segments = 10000; segments <= 10000000; segments *= 10)
  {
    vtkNew<vtkAnalyticLineSource> source;
    source->SetNumberOfSegments(segments);
    source->Update();
    double numbers[4] = { source->GetOutput()->GetActualMemorySize() / 1024.0 };
    double seconds = 0.0;
    for (int i = 1; i < 4; ++i)
    {
      Setting setting{ "", "", Spirals(options.Radius) };
      setting.Lines.Order = 1 << i;
      const double start = ProcessorSeconds();
      numbers[i] = Voxelize(source->GetOutput(), setting)->GetActualMemorySize() / 1024.0;
      seconds = i == 2 ? ProcessorSeconds() - start : seconds;
    }
    for (int i = 0; i < 4; ++i)
    {
      plot.Series[i].Points.push_back({ 1.0 * segments, numbers[i], "" });
    }
    csv.Write(segments, numbers[0], seconds, numbers[1], numbers[2], numbers[3]);
    measuring.Line(std::to_string(segments) + " segments");
  }
  WriteSvg(options.Folder + "/lines-storage.svg", plot);
}
}

void TradeLines(const LinesTradeOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  if (options.Knob.empty() || options.Knob == "segments")
  {
    TradeStorage(options);
  }
  if (options.Knob == "segments")
  {
    return;
  }
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(options.Segments);
  source->Update();
  vtkPolyData* lines = source->GetOutput();
  Setting first{ "", "", Spirals(options.Radius) };
  FramePicture truth;
  vtkNew<vtkCamera> camera; // that of the tubes, whatever the bounds of what is drawn
  {
    const Progress tubes("Drawing tubes at 10 x 10 the resolution");
    LineScene scene(Voxelize(lines, first), MakePicture(options.Size), OffScreenWindow(options.Headless));
    camera->DeepCopy(scene.GetScene().GetRenderer()->GetActiveCamera());
    truth = DrawTubes(lines, Spirals(options.Radius), scene.GetScene()).Frame;
  }
  WritePng(truth, options.Folder + "/lines-tubes.png");
  const FramePicture smallTruth = Reduced(truth, 2);
  CsvWriter csv(options.Folder + "/lines.csv",
    { "knob", "value", "voxelize s", "frame s", "MiB", "MiB of the mapper", "PSNR dB", "PSNR of 2 x 2 dB" });
  const std::string error = "root mean square error of 2 x 2";
  Plot time{ "Spirals against tubes: error by time", "to voxelize, s", error, {} };
  Plot memory{ "Spirals against tubes: error by memory", "MiB", error, {} };
  Progress measuring("Measuring");
  for (const Setting& setting : Settings(options.Radius))
  {
    if (!options.Knob.empty() && setting.Knob != options.Knob)
    {
      continue;
    }
    const Result result = Measure(lines, setting, camera, options);
    const double raw = SignalToNoise(truth, result.Frame);
    const double reduced = SignalToNoise(smallTruth, Reduced(result.Frame, 2));
    csv.Write(setting.Knob, setting.Value, result.VoxelizeSeconds, result.FrameSeconds, result.VoxelMiB,
      result.MapperMiB, raw, reduced);
    measuring.Line(setting.Knob + " " + setting.Value);
    AddPoint(time, setting, result.VoxelizeSeconds, reduced);
    AddPoint(memory, setting, result.VoxelMiB, reduced);
    if (setting.Knob == "grid" && setting.Value == "256")
    {
      WritePng(result.Frame, options.Folder + "/lines-voxels.png");
    }
  }
  WriteSvg(options.Folder + "/lines.svg", time);
  WriteSvg(options.Folder + "/lines-memory.svg", memory);
}
