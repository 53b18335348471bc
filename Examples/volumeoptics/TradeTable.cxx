// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeTable.h"

#include "CsvWriter.h"
#include "GalleryField.h"
#include "Progress.h"
#include "VolumeScene.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkImageData.h"
#include "vtkSobelNormalFilter.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

namespace
{
struct Row
{
  std::string Field;
  double Factor;
  int Samples;
  double Radius;
};

std::vector<Row> Rows(const TableOptions& options)
{
  std::vector<Row> rows = { { "tubes", 0.5, 100, 10.0 }, { "ellipsoid", 0.5, 500, 40.0 },
    { "marschner-lobb", 0.75, 100, 20.0 }, { "packed", 1.0, 50, 7.0 } };
  if (!options.Cranium.empty())
  {
    rows.push_back({ "cranium", 1.0, 100, 10.0 });
  }
  return rows;
}

template <typename Filter>
double SecondsOf(Filter* filter)
{
  const auto begin = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return elapsed.count();
}

struct Preprocessing
{
  double NormalSeconds, CovarianceSeconds;
  double NormalMiB, CovarianceMiB; // at 8 bits: normal and magnitude, three numbers
};

Preprocessing Measure(vtkImageData* image, const Row& row)
{
  vtkNew<vtkSobelNormalFilter> normals;
  normals->SetInputData(image);
  normals->SetResolutionFactor(row.Factor);
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetInputData(0, image);
  covariance->SetInputConnection(1, normals->GetOutputPort());
  covariance->SetResolutionFactor(row.Factor);
  covariance->SetRadius(row.Radius);
  covariance->SetNumberOfSamples(row.Samples);
  Preprocessing result;
  result.NormalSeconds = SecondsOf(normals.Get());
  result.CovarianceSeconds = SecondsOf(covariance.Get());
  const double voxels = static_cast<double>(normals->GetOutput()->GetNumberOfPoints()) / 1048576.0;
  result.NormalMiB = 4.0 * voxels;
  result.CovarianceMiB = 3.0 * voxels;
  return result;
}

PictureSettings Picture(const TableOptions& options, const Row& row, const std::string& model)
{
  PictureSettings picture;
  if (row.Field == "cranium")
  {
    picture.Function = Preset("bone");
  }
  else
  {
    picture.Function.Opacity = { { 0.42, 0.0 }, { 0.58, 0.9 } };
    picture.Function.Color = { { 0.5, 0.45, 0.6, 0.72 } };
  }
  picture.Optics.Model = model;
  picture.Ambient.Radius = row.Radius;
  picture.Ambient.Samples = row.Samples;
  picture.Ambient.ResolutionFactor = row.Factor;
  picture.Camera = { 25.0, 15.0, 0.0, 1.5, {}, {}, {} };
  picture.Size = { options.Size, options.Size };
  return picture;
}

// Frames of the models alternate, so that a noisy machine slows all of them.
std::vector<double> FrameSeconds(
  const Volume& volume, const TableOptions& options, const Row& row, const std::vector<std::string>& models)
{
  std::vector<std::unique_ptr<VolumeScene>> scenes;
  std::vector<std::vector<double>> seconds(models.size());
  for (const std::string& model : models)
  {
    scenes.push_back(std::make_unique<VolumeScene>(volume, OffScreenWindow(options.Headless)));
    scenes.back()->Apply(Picture(options, row, model));
    scenes.back()->Render();
  }
  for (int frame = 0; frame < options.Frames; ++frame)
  {
    for (std::size_t i = 0; i < models.size(); ++i)
    {
      seconds[i].push_back(scenes[i]->Render());
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& times : seconds)
  {
    std::sort(times.begin(), times.end());
    medians.push_back(times[times.size() / 2]);
  }
  return medians;
}
}

void TradeTable(const TableOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  const std::vector<std::string> models = { "vtk", "none", "blinn-phong", "ward", "lafortune" };
  if (!options.Cranium.empty())
  {
    GalleryField("cranium", options.Cranium); // a file that cannot be read is told before minutes of others
  }
  CsvWriter csv(options.Folder + "/table.csv",
    { "data", "size", "grid factor", "n", "r", "N ms", "N MiB", "C ms", "C MiB", "stock VTK fps", "none fps",
      "blinn-phong fps", "ward fps", "lafortune fps" });
  for (const Row& row : Rows(options))
  {
    const Volume volume = GalleryField(row.Field, options.Cranium);
    const Progress progress(row.Field);
    const int* size = volume.Image->GetDimensions();
    const Preprocessing cost = Measure(volume.Image, row);
    const std::vector<double> frames = FrameSeconds(volume, options, row, models);
    csv.Write(row.Field,
      std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2]), row.Factor,
      row.Samples, row.Radius, 1000.0 * cost.NormalSeconds, cost.NormalMiB, 1000.0 * cost.CovarianceSeconds,
      cost.CovarianceMiB, 1.0 / frames[0], 1.0 / frames[1], 1.0 / frames[2], 1.0 / frames[3],
      1.0 / frames[4]);
  }
  Progress::Say(options.Folder + "/table.csv written");
}
