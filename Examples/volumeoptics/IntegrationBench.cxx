// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "IntegrationBench.h"

#include "GalleryField.h"
#include "VolumeScene.h"

#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPreIntegratedTable.h"

#include <vtkRenderer.h>
#include <vtkTimerLog.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace
{
constexpr int NumberOfTriangles = 16;
constexpr double FineStep = 0.25;  // voxels: below, a frame takes so long that its first is as good
constexpr double TrueStep = 0.125; // voxels, halved where the field bends
constexpr double TrueLinearity = 2.0e-5;

vtkVolume* VolumeOf(VolumeScene& scene)
{
  return vtkVolume::SafeDownCast(scene.GetRenderer()->GetVolumes()->GetItemAsObject(0));
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

PictureSettings Picture(const BenchFunction& function, int size)
{
  PictureSettings picture;
  picture.Function = function.Function;
  picture.Function.Shade = false;
  picture.Camera = { 25.0, 50.0, 0.0, 1.5, {}, {}, {} };
  picture.Size = { size, size };
  picture.Background = { 0.0, 0.0, 0.0 };
  return picture;
}
}

BenchFunction SmoothFunction()
{
  BenchFunction smooth{ "smooth", {} };
  smooth.Function.Opacity = { { 0.0, 0.0 }, { 0.5, 0.6 }, { 1.0, 0.0 } };
  smooth.Function.Color = { { 0.0, 0.2, 0.4, 0.9 }, { 1.0, 0.9, 0.6, 0.2 } };
  smooth.Function.UnitDistance = 12.0;
  smooth.Function.Integration.UnitInterval = 0.5;
  return smooth;
}

BenchFunction SpikyFunction(double width)
{
  BenchFunction spiky{ "spiky 1/" + std::to_string(std::lround(1.0 / width)), {} };
  TransferFunction& function = spiky.Function;
  function.Opacity = { { 0.0, 0.0 } };
  for (int i = 0; i < NumberOfTriangles; ++i)
  {
    const double value = (i + 0.5) / NumberOfTriangles;
    function.Opacity.push_back({ value - 0.5 * width, 0.0 });
    function.Opacity.push_back({ value, 0.9 });
    function.Opacity.push_back({ value + 0.5 * width, 0.0 });
    const double share = static_cast<double>(i) / (NumberOfTriangles - 1);
    const double blue = i % 2 == 0 ? 0.9 : 0.2;
    function.Color.push_back({ value, 0.3 + 0.7 * share, 1.0 - 0.7 * share, blue });
  }
  function.Opacity.push_back({ 1.0, 0.0 });
  function.UnitDistance = 70.0 * width;
  function.Integration.UnitInterval = 5.0 * width;
  return spiky;
}

IntegrationBench::IntegrationBench(int size, bool headless)
  : Size(size)
  , Headless(headless)
  , Data(GalleryField("marschner-lobb", ""))
{
  VolumeScene& scene = this->Stage(SmoothFunction(), "physical", "post", 4.0, {});
  scene.Render();
  const std::string renderer = scene.GetRendererName();
  this->Software = renderer.find("pipe") != std::string::npos; // Mesa's llvmpipe or softpipe
}

IntegrationBench::~IntegrationBench() = default;

double IntegrationBench::Now() const
{
  return this->Software ? static_cast<double>(std::clock()) / CLOCKS_PER_SEC
                        : vtkTimerLog::GetUniversalTime();
}

double IntegrationBench::FrameSeconds(VolumeScene& scene) const
{
  const double start = this->Now();
  scene.Render();
  return this->Now() - start;
}

VolumeScene& IntegrationBench::Stage(const BenchFunction& function, const std::string& space,
  const std::string& classification, double step, const BenchTable& table)
{
  std::unique_ptr<VolumeScene>& scene = this->Scenes[space + classification];
  if (!scene)
  {
    scene = std::make_unique<VolumeScene>(this->Data, OffScreenWindow(this->Headless));
  }
  PictureSettings picture = Picture(function, this->Size);
  picture.Step = step;
  picture.Function.Integration.Space = space;
  picture.Function.Integration.Classification = classification;
  scene->GetMapper()->SetPreIntegrationTableSize(table.Size);
  scene->GetMapper()->SetTablePrecision(table.Bits);
  scene->Apply(picture);
  return *scene;
}

// Segments integrated by quadrature, and halved until the field is linear on them.
const reference::Image& IntegrationBench::Truth(const BenchFunction& function, const std::string& space)
{
  const auto known = this->Truths.find(function.Name + space);
  if (known != this->Truths.end())
  {
    return known->second;
  }
  VolumeScene& scene = this->Stage(function, space, "pre-integrated", 1.0, {});
  scene.Render();
  reference::Scene exact =
    reference::SceneFromVTK(scene.GetRenderer(), VolumeOf(scene), this->Size, this->Size);
  exact.step = TrueStep;
  exact.linearity = TrueLinearity;
  exact.terminatesEarly = false;
  return this->Truths.emplace(function.Name + space, reference::Render(exact)).first->second;
}

double IntegrationBench::TableSeconds(const BenchFunction& function, const std::string& space, int size) const
{
  vtkNew<vtkOpticsVolumeProperty> property;
  Apply(function.Function, property);
  vtkNew<vtkPreIntegratedTable> table;
  table->SetColorFunction(property->GetRGBTransferFunction());
  table->SetOpacityFunction(property->GetScalarOpacity());
  table->SetUnitInterval(function.Function.Integration.UnitInterval);
  table->SetSegmentLength(space == "physical" ? 1.0 / function.Function.UnitDistance : 0.0);
  table->SetRange(this->Data.Image->GetScalarRange());
  table->SetSize(size);
  std::vector<double> seconds;
  for (int i = 0; i < 3; ++i)
  {
    table->Modified();
    const double start = this->Now();
    table->Update();
    seconds.push_back(this->Now() - start);
  }
  return Median(seconds);
}

BenchFrame IntegrationBench::Judge(const BenchFunction& function, const std::string& space,
  const std::string& classification, double step, const BenchTable& table)
{
  const reference::Image& truth = this->Truth(function, space);
  VolumeScene& scene = this->Stage(function, space, classification, step, table);
  BenchFrame frame;
  frame.FrameSeconds = this->FrameSeconds(scene);
  const reference::Difference error = reference::Compare(truth, scene.Capture());
  frame.Step = step;
  frame.RootMeanSquare = error.rootMeanSquare;
  frame.Maximum = error.maximum;
  if (classification == "pre-integrated")
  {
    frame.TableSeconds = this->TableSeconds(function, space, table.Size);
    frame.TableKiB = static_cast<double>(scene.GetMapper()->GetTermMemorySize());
  }
  return frame;
}

BenchFrame IntegrationBench::Measure(const BenchFunction& function, const std::string& space,
  const std::string& classification, double step, const BenchTable& table)
{
  BenchFrame frame = this->Judge(function, space, classification, step, table);
  if (step >= FineStep || classification == "pre-integrated") // whose first frame builds the table
  {
    VolumeScene& scene = *this->Scenes[space + classification];
    frame.FrameSeconds =
      Median({ this->FrameSeconds(scene), this->FrameSeconds(scene), this->FrameSeconds(scene) });
  }
  return frame;
}

std::pair<BenchFrame, BenchFrame> IntegrationBench::MeasurePair(
  const BenchFunction& function, const std::string& space, double step, const BenchTable& table)
{
  BenchFrame post = this->Judge(function, space, "post", step, table);
  BenchFrame pre = this->Judge(function, space, "pre-integrated", step, table);
  std::vector<double> postSeconds, preSeconds;
  for (int i = 0; i < 5; ++i)
  {
    postSeconds.push_back(this->FrameSeconds(*this->Scenes[space + "post"]));
    preSeconds.push_back(this->FrameSeconds(*this->Scenes[space + "pre-integrated"]));
  }
  post.FrameSeconds = Median(postSeconds);
  pre.FrameSeconds = Median(preSeconds);
  return { post, pre };
}
