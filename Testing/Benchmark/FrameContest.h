// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Frames of several mappers and settings of one scene, drawn in turns, so that a noisy machine slows all of them;
// medians of wall time and of processor time.

#ifndef FrameContest_h
#define FrameContest_h

#include "FrameTimes.h"
#include "vtkAnalyticVolumeSource.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace
{
// What all contestants draw.
struct ContestScene
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  std::vector<std::pair<double, double>> Opacities; // at scalars, of a length of two default steps
  bool IsShaded = true;
  int Size = 512;    // pixels on each side
  double Step = 0.0; // 0: half the smallest spacing
  std::vector<std::pair<double, double>>
    GradientOpacities = {}; // at half differences of neighbours; empty: none
};

inline vtkSmartPointer<vtkImageData> ReadContestImage(const std::string& file)
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

inline vtkSmartPointer<vtkImageData> MarschnerLobb()
{
  vtkNew<vtkAnalyticVolumeSource> source;
  source->SetDimensions(128, 128, 128);
  source->Update();
  return source->GetOutput();
}

// One window, mapper and volume.
class Contestant
{
public:
  using Change = std::function<void(vtkOpticsVolumeProperty*)>;

  Contestant(
    std::string name, const ContestScene& scene, vtkGPUVolumeRayCastMapper* mapper,
    const Change& change = [](vtkOpticsVolumeProperty*) {})
    : Name(std::move(name))
  {
    vtkNew<vtkOpticsVolumeProperty> property;
    this->SetUp(scene, mapper, property);
    change(property);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->SetProperty(property);
    this->Show(volume, scene.Size);
  }

  // Of anything else.
  Contestant(std::string name, vtkProp* prop, int size)
    : Name(std::move(name))
  {
    this->Show(prop, size);
  }

  // From a camera that has moved: what is found for each view is found anew.
  void Draw()
  {
    this->Renderer->GetActiveCamera()->Azimuth(1.0);
    this->Times.Draw(this->Window);
  }

  double GetSeconds() const { return this->Times.GetSeconds(); }
  double GetProcessorSeconds() const { return this->Times.GetProcessorSeconds(); }
  double GetRatio(const Contestant& other) const { return this->Times.GetRatio(other.Times); }

  std::vector<unsigned char> GetPixels()
  {
    const int* size = this->Window->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.Get(), 0);
    return std::vector<unsigned char>(
      pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  }

  std::string Name;

private:
  void Show(vtkProp* prop, int size)
  {
    this->Renderer->AddViewProp(prop);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->SetPosition(0.4, 1.0, 0.3);
    this->Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(1.5);
    this->Window->Render(); // uploads, links, estimates frames, finds ranges
  }

  static void SetUp(
    const ContestScene& scene, vtkGPUVolumeRayCastMapper* mapper, vtkOpticsVolumeProperty* property)
  {
    const double* spacing = scene.Image->GetSpacing();
    const double step = std::min({ spacing[0], spacing[1], spacing[2] }) / 2.0;
    mapper->SetInputData(scene.Image);
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetUseJittering(0);
    mapper->SetSampleDistance(static_cast<float>(scene.Step > 0.0 ? scene.Step : step));
    vtkNew<vtkPiecewiseFunction> opacity;
    for (const auto& [scalar, value] : scene.Opacities)
    {
      opacity->AddPoint(scalar, value);
    }
    vtkNew<vtkPiecewiseFunction> gradientOpacity;
    for (const auto& [gradient, value] : scene.GradientOpacities)
    {
      gradientOpacity->AddPoint(gradient, value);
    }
    if (!scene.GradientOpacities.empty())
    {
      property->SetGradientOpacity(gradientOpacity);
    }
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(scene.Opacities.front().first, 0.8, 0.5, 0.4);
    color->AddRGBPoint(scene.Opacities.back().first, 0.9, 0.9, 0.8);
    property->SetScalarOpacity(opacity);
    property->SetColor(color);
    property->SetScalarOpacityUnitDistance(2.0 * step);
    property->SetInterpolationTypeToLinear();
    property->SetShade(scene.IsShaded);
  }

  vtkNew<vtkHeadlessRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  FrameTimes Times;
};

using Contestants = std::vector<std::unique_ptr<Contestant>>;

inline void DrawInTurns(Contestants& contestants, int frames)
{
  for (int frame = 0; frame < frames; ++frame)
  {
    for (auto& contestant : contestants)
    {
      contestant->Draw();
    }
  }
}

// Scenes of docs/performance.md, from almost empty to full. cranium: a CT in Hounsfield units, or null.
inline std::vector<ContestScene> ContestScenes(vtkImageData* cranium, int size)
{
  std::vector<ContestScene> scenes;
  if (cranium)
  {
    scenes.push_back({ "cranium, bone", cranium, { { 200.0, 0.0 }, { 600.0, 0.9 } } });
    scenes.push_back({ "cranium, skin and bone", cranium,
      { { -300.0, 0.0 }, { -200.0, 0.05 }, { 0.0, 0.05 }, { 150.0, 0.1 }, { 500.0, 0.9 } } });
  }
  const vtkSmartPointer<vtkImageData> field = MarschnerLobb();
  scenes.push_back({ "Marschner-Lobb, a shell", field, { { 0.48, 0.0 }, { 0.5, 0.9 }, { 0.52, 0.0 } } });
  scenes.push_back({ "Marschner-Lobb, an opaque cube", field, { { 0.0, 0.5 }, { 1.0, 0.9 } } });
  scenes.push_back({ "Marschner-Lobb, transparent fog", field, { { 0.0, 0.001 }, { 1.0, 0.002 } } });
  for (ContestScene& scene : scenes)
  {
    scene.Size = size;
  }
  return scenes;
}
}

#endif
