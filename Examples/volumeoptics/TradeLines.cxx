// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeLines.h"

#include "CsvWriter.h"
#include "LineScene.h"
#include "Progress.h"
#include "SvgPlot.h"

#include "vtkAnalyticLineSource.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>

namespace
{
const int Supersampling = 10;

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

struct Picture
{
  int Width = 0, Height = 0;
  std::vector<double> Values; // rgb
};

// Means of factor x factor pixels.
Picture Reduced(const Picture& picture, int factor)
{
  Picture small{ picture.Width / factor, picture.Height / factor, {} };
  small.Values.assign(3 * small.Width * small.Height, 0.0);
  for (int y = 0; y < small.Height * factor; ++y)
  {
    for (int x = 0; x < small.Width * factor; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        small.Values[3 * (y / factor * small.Width + x / factor) + c] +=
          picture.Values[3 * (y * picture.Width + x) + c] / (factor * factor);
      }
    }
  }
  return small;
}

Picture ToPicture(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  Picture picture{ size[0], size[1], {} };
  const int components = image->GetNumberOfScalarComponents();
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    picture.Values.insert(picture.Values.end(), bytes + i * components, bytes + i * components + 3);
  }
  return picture;
}

// Over the pixels that either picture covers; the background is black.
double SignalToNoise(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  long long count = 0;
  for (std::size_t i = 0; i < a.Values.size(); i += 3)
  {
    double square = 0.0, most = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      square += std::pow(a.Values[i + c] - b.Values[i + c], 2.0);
      most = std::max(most, std::max(a.Values[i + c], b.Values[i + c]));
    }
    sum += most >= 0.5 ? square : 0.0;
    count += most >= 0.5 ? 3 : 0;
  }
  return sum > 0.0 ? 10.0 * std::log10(255.0 * 255.0 * count / sum) : 99.0;
}

void WritePicture(const Picture& picture, const std::string& path)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::transform(picture.Values.begin(), picture.Values.end(),
    static_cast<unsigned char*>(image->GetScalarPointer()),
    [](double value) { return static_cast<unsigned char>(std::lround(value)); });
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
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

// The scene of the voxels with tubes in the volume's place. VTK's lobe is Phong's: a fourth of Blinn's
// exponent is as wide.
Picture DrawTubes(vtkPolyData* lines, LineScene& scene, int size, double radius)
{
  const LineSettings settings = Spirals(radius);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(settings.Color[0], settings.Color[1], settings.Color[2]);
  actor->GetProperty()->SetSpecularColor(1.0, 1.0, 1.0);
  actor->GetProperty()->SetAmbient(settings.Ambient);
  actor->GetProperty()->SetDiffuse(settings.Diffuse);
  actor->GetProperty()->SetSpecular(settings.Specular);
  actor->GetProperty()->SetSpecularPower(settings.SpecularPower / 4.0);
  vtkRenderer* renderer = scene.GetScene().GetRenderer();
  renderer->RemoveAllViewProps();
  renderer->AddActor(actor);
  scene.GetScene().GetWindow()->SetSize(size * Supersampling, size * Supersampling);
  scene.Render();
  Picture picture = Reduced(ToPicture(scene.GetScene().Capture()), Supersampling);
  renderer->RemoveActor(actor);
  return picture;
}

struct Result
{
  Picture Frame;
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
  result.Frame = ToPicture(scene.GetScene().Capture());
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
  Picture truth;
  {
    const Progress tubes("Drawing tubes at 10 x 10 the resolution");
    LineScene scene(Voxelize(lines, first), MakePicture(options.Size), OffScreenWindow(options.Headless));
    truth = DrawTubes(lines, scene, options.Size, options.Radius);
  }
  WritePicture(truth, options.Folder + "/lines-tubes.png");
  const Picture smallTruth = Reduced(truth, 2);
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
      WritePicture(result.Frame, options.Folder + "/lines-voxels.png");
    }
  }
  WriteSvg(options.Folder + "/lines.svg", plot);
}
