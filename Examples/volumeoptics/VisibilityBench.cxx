// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibilityBench.h"

#include "GalleryField.h"
#include "GalleryScenes.h"
#include "VolumeScene.h"

#include "vtkOpticsVolumeMapper.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace
{
constexpr double StepOfRays = 0.25; // of the truth, in voxels
constexpr double StepOfTruth =
  0.125; // of the samples, in steps of the picture: each of these stands for all of its step
constexpr int TimedFrames = 5;
constexpr double LeastWeight = 0.002; // of a sample: below, it can't be seen
constexpr double SeenOpacity = 0.5;   // of a pixel whose error counts as a maximum

// White.
PictureSettings Picture(const std::string& field, bool isLit)
{
  PictureSettings picture = field == "cranium" ? Cranium() : MarschnerLobb();
  picture.Step = 0.5;
  picture.Function.Shade = isLit;
  picture.Optics.Model = "vtk";
  picture.Function.Color = { { 0.0, 1.0, 1.0, 1.0 } };
  picture.Background = { 0.0, 0.0, 0.0 };
  return picture;
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Red of every pixel, from the lowest row.
std::vector<double> RedOf(vtkImageData* picture)
{
  vtkDataArray* scalars = picture->GetPointData()->GetScalars();
  std::vector<double> red;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    red.push_back(scalars->GetComponent(i, 0) / 255.0);
  }
  return red;
}
}

VisibilityBench::VisibilityBench(const Options& options)
  : Setup(options)
{
  const Volume data = GalleryField(options.Field, options.Cranium);
  for (auto* scene : { &this->Pictures, &this->WithOcclusion, &this->Without })
  {
    *scene = std::make_unique<VolumeScene>(data, OffScreenWindow(options.Headless));
  }
  this->Stage(*this->Pictures, options.Size, -1.0, {});
  this->Pictures->Render();
  this->Software = this->Pictures->GetRendererName().find("pipe") != std::string::npos; // Mesa's rasterisers
  auto* volume = vtkVolume::SafeDownCast(this->Pictures->GetRenderer()->GetVolumes()->GetItemAsObject(0));
  this->World = reference::SceneFromVTK(this->Pictures->GetRenderer(), volume, options.Size, options.Size);
  this->Things =
    std::make_unique<reference::Occluders>(this->World, StepOfRays * this->World.grid.SmallestSpacing());
  this->World.step *= StepOfTruth;
  this->Points = reference::ShownPoints(this->World, LeastWeight * StepOfTruth);
  this->Opacity.resize(static_cast<std::size_t>(options.Size) * options.Size);
  for (const reference::ShownPoint& point : this->Points)
  {
    this->Opacity[point.pixel] += point.weight;
  }
}

VisibilityBench::~VisibilityBench() = default;

// angle: below 0 without occlusion.
void VisibilityBench::Stage(
  VolumeScene& scene, int size, double angle, const VisibilityKnobs& knobs, const FrameKind& kind) const
{
  PictureSettings picture = Picture(this->Setup.Field, kind.IsLit);
  picture.Size = { size, size };
  picture.Visibility.OcclusionAngle = angle;
  picture.Quality = knobs.Quality;
  picture.Visibility.Algorithm = knobs.Algorithm;
  picture.Visibility.GridSize = knobs.GridSize;
  picture.Visibility.SliceDistance = knobs.SliceDistance;
  picture.Visibility.Samples = knobs.Samples;
  picture.Visibility.GatherSamples = knobs.GatherSamples;
  picture.Visibility.DiskSize = knobs.DiskSize;
  scene.GetMapper()->SetVisibilityPrecision(knobs.Precision);
  scene.GetMapper()->SetSkipEmptySpace(kind.SkipsEmptySpace);
  scene.Apply(picture);
}

std::vector<double> VisibilityBench::Rays(double angle, unsigned seed, const reference::Vector* axis) const
{
  return reference::VisibilityAt(
    *this->Things, this->Points, reference::ConeRays{ angle, this->Setup.Rays, seed }, axis);
}

const std::vector<double>& VisibilityBench::Truth(double angle)
{
  const auto known = this->Truths.find(angle);
  return known != this->Truths.end() ? known->second
                                     : this->Truths.emplace(angle, this->Rays(angle, 1)).first->second;
}

// radiance: associated with the pixels' opacity.
PictureError VisibilityBench::ComparePixels(const std::vector<double>& radiance, double angle)
{
  const std::vector<double> truth =
    reference::MeanOfPixels(this->Points, this->Truth(angle), static_cast<int>(this->Opacity.size()));
  PictureError error;
  double opacities = 0.0;
  for (std::size_t i = 0; i < radiance.size(); ++i)
  {
    const double off = std::abs(radiance[i] - this->Opacity[i] * truth[i]);
    if (this->Opacity[i] <= 0.0)
    {
      continue;
    }
    error.Mean += off;
    opacities += this->Opacity[i];
    if (this->Opacity[i] > SeenOpacity)
    {
      error.Maximum = std::max(error.Maximum, off / this->Opacity[i]);
    }
  }
  error.Mean /= std::max(opacities, 1.0e-300);
  return error;
}

PictureError VisibilityBench::Judge(double angle, const VisibilityKnobs& knobs)
{
  this->Stage(*this->Pictures, this->Setup.Size, angle, knobs);
  this->Pictures->Render();
  return this->ComparePixels(RedOf(this->Pictures->Capture()), angle);
}

double VisibilityBench::FrameSeconds(VolumeScene& scene) const
{
  // another view, so that nothing of the frame before can be kept
  const auto now = [this] {
    return this->Software ? static_cast<double>(std::clock()) / CLOCKS_PER_SEC
                          : vtkTimerLog::GetUniversalTime();
  };
  scene.GetRenderer()->GetActiveCamera()->Azimuth(0.1);
  const double start = now();
  scene.Render();
  return now() - start;
}

FrameCost VisibilityBench::Time(double angle, const VisibilityKnobs& knobs, const FrameKind& kind)
{
  this->Stage(*this->WithOcclusion, this->Setup.FrameSize, angle, knobs, kind);
  this->Stage(*this->Without, this->Setup.FrameSize, -1.0, knobs, kind);
  this->WithOcclusion->Render();
  this->Without->Render();
  std::vector<double> with, without;
  for (int i = 0; i < TimedFrames; ++i)
  {
    with.push_back(this->FrameSeconds(*this->WithOcclusion));
    without.push_back(this->FrameSeconds(*this->Without));
  }
  return { Median(with), Median(without),
    static_cast<double>(this->WithOcclusion->GetMapper()->GetTermMemorySize()) };
}

VisibilityBench::AlgorithmError VisibilityBench::Compare(const std::vector<double>& values, double angle)
{
  std::vector<double> radiance(this->Opacity.size(), 0.0);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    radiance[this->Points[i].pixel] += this->Points[i].weight * values[i];
  }
  return { reference::CompareVisibility(this->Points, values, this->Truth(angle)),
    this->ComparePixels(radiance, angle) };
}

VisibilityBench::AlgorithmError VisibilityBench::JudgeAlgorithm(
  double angle, int size, double sliceDistance, reference::SweepSettings settings)
{
  const reference::SliceFrame frame = reference::FrameOfCamera(this->World);
  settings.angle = angle;
  settings.froxels = reference::FroxelsOf(frame, size, sliceDistance);
  return this->Compare(
    reference::FroxelSweep(*this->Things, frame, settings).At(*this->Things, this->Points), angle);
}

VisibilityBench::AlgorithmError VisibilityBench::NoiseOfTruth(double angle)
{
  return this->Compare(this->Rays(angle, 2), angle);
}

VisibilityBench::AlgorithmError VisibilityBench::AxisOfCone(double angle)
{
  const reference::Vector axis = -reference::FrameOfCamera(this->World).away;
  return this->Compare(this->Rays(angle, 1, &axis), angle);
}
