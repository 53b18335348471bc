// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TradeShading.h"

#include "CsvWriter.h"
#include "GalleryField.h"
#include "Progress.h"
#include "SvgPlot.h"
#include "VolumeScene.h"

#include "RayCaster.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkSobelNormalFilter.h"

#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <filesystem>

namespace
{
// Beside the knob that is turned, everything is at its finest: exhaustive samples, floats, half a voxel.
struct Setting
{
  std::string Knob, Value;
  double Step = 0.5;
  int Precision = 32;
  double ResolutionFactor = 1.0;
  bool CentralDifferences = false;
  int Storage = vtkAmbientCovarianceFilter::Map;
  int Samples = 0; // 0: exhaustive
};

void AddStorages(std::vector<Setting>& settings)
{
  const std::pair<const char*, int> storages[] = { { "map", vtkAmbientCovarianceFilter::Map },
    { "components", vtkAmbientCovarianceFilter::Components },
    { "world", vtkAmbientCovarianceFilter::World } };
  for (const auto& [name, storage] : storages)
  {
    for (const int bits : { 8, 32 })
    {
      Setting setting{ "storage", std::string(name) + " " + std::to_string(bits) };
      setting.Precision = bits;
      setting.Storage = storage;
      settings.push_back(setting);
    }
  }
}

std::vector<Setting> Settings()
{
  std::vector<Setting> settings;
  for (const char* step : { "2", "1", "0.5", "0.25", "0.125" })
  {
    settings.push_back({ "step length", step, std::stod(step) });
  }
  for (const char* bits : { "8", "16", "32" })
  {
    settings.push_back({ "bits", bits, 0.5, std::stoi(bits) });
  }
  for (const char* factor : { "0.25", "0.5", "0.75", "1" })
  {
    settings.push_back({ "grid factor", factor, 0.5, 32, std::stod(factor) });
  }
  settings.push_back({ "extinction gradient", "stored", 0.5, 32, 1.0, false });
  settings.push_back({ "extinction gradient", "central", 0.5, 32, 1.0, true });
  AddStorages(settings);
  for (const char* samples : { "30", "100", "300", "1000" })
  {
    Setting setting{ "samples", samples };
    setting.Samples = std::stoi(samples);
    settings.push_back(setting);
  }
  return settings;
}

PictureSettings Picture(const ShadingTradeOptions& options)
{
  PictureSettings picture;
  picture.Function.Opacity = { { 0.42, 0.0 }, { 0.58, 0.9 }, { 10.0, 0.9 } };
  picture.Function.Color = { { 0.5, 0.45, 0.6, 0.72 } };
  picture.Optics.Model = options.Model;
  picture.Ambient.Radius = 6.0;
  picture.Camera = { 30.0, 15.0, 0.0, 1.3, {}, {}, {} };
  picture.Lights = { { -20.0, 25.0, 1.0 } };
  picture.Size = { options.Size, options.Size };
  picture.Background = { 0.0, 0.0, 0.0 };
  return picture;
}

// The scene as it stands, with frames of the exhaustive ball on the full grid and a fine step. The frames
// are those of the world tensor, which has neither a pole nor a sign.
reference::Image Truth(VolumeScene& scene, vtkImageData* image, const PictureSettings& picture)
{
  vtkNew<vtkSobelNormalFilter> normals;
  normals->SetInputData(image);
  normals->Update();
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetInputData(image);
  covariance->SetRadius(picture.Ambient.Radius);
  covariance->SetSamplingPatternToExhaustive();
  covariance->SetStorageToWorld();
  covariance->SetScalarTolerance(picture.Ambient.Tolerance);
  covariance->Update();
  auto* volume = vtkVolume::SafeDownCast(scene.GetRenderer()->GetVolumes()->GetItemAsObject(0));
  reference::Scene exact =
    reference::SceneFromVTK(scene.GetRenderer(), volume, picture.Size[0], picture.Size[1]);
  exact.frames =
    std::make_shared<reference::GridFrameField>(vtkImageData::SafeDownCast(normals->GetOutputDataObject(0)),
      vtkImageData::SafeDownCast(covariance->GetOutputDataObject(0)), reference::Storage::World);
  exact.step = 1.0 / 16.0;
  return reference::Render(exact);
}

double MedianFrame(VolumeScene& scene)
{
  double seconds[3];
  for (double& time : seconds)
  {
    time = scene.Render();
  }
  std::sort(seconds, seconds + 3);
  return seconds[1];
}
}

void TradeShading(const ShadingTradeOptions& options)
{
  std::filesystem::create_directories(options.Folder);
  const Volume volume = GalleryField(options.Field, "");
  VolumeScene scene(volume, OffScreenWindow(options.Headless));
  PictureSettings picture = Picture(options);
  scene.GetMapper()->SetMaxMemoryInBytes(vtkIdType(1) << 31); // no knob is turned by a lack of memory
  scene.Apply(picture);
  scene.Render();
  const reference::Image truth = [&] {
    const Progress exact("Reference in double precision");
    return Truth(scene, volume.Image, picture);
  }();
  CsvWriter csv(options.Folder + "/shading.csv", { "knob", "value", "seconds", "rmse", "maximum" });
  Plot plot{ "Shading: time of a frame against error", "seconds", "RMSE of a picture in [0, 1]", {} };
  for (const Setting& setting : Settings())
  {
    picture.Step = setting.Step;
    picture.Ambient.Precision = setting.Precision;
    picture.Ambient.ResolutionFactor = setting.ResolutionFactor;
    picture.Ambient.Pattern = setting.Samples > 0 ? "shared" : "exhaustive";
    picture.Ambient.Samples = setting.Samples > 0 ? setting.Samples : 100;
    scene.GetMapper()->GetAmbientCovarianceFilter()->SetStorage(setting.Storage);
    scene.GetMapper()->SetExtinctionGradient(
      setting.CentralDifferences ? vtkOpticsVolumeMapper::CentralDifferences : vtkOpticsVolumeMapper::Stored);
    scene.Apply(picture);
    scene.Render();
    const double seconds = MedianFrame(scene);
    const reference::Difference error = reference::Compare(truth, scene.Capture());
    csv.Write(setting.Knob, setting.Value, seconds, error.rootMeanSquare, error.maximum);
    if (plot.Series.empty() || plot.Series.back().Name != setting.Knob)
    {
      plot.Series.push_back({ setting.Knob, {} });
    }
    plot.Series.back().Points.push_back({ seconds, error.rootMeanSquare, setting.Value });
  }
  WriteSvg(options.Folder + "/shading.svg", plot);
  Progress::Say(options.Folder + "/shading.csv and shading.svg written");
}
