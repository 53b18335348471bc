// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows of the mapper beside VTK's own volumetric shadows, which VTK 9.2 and later have (with an older one they are
// left out): error against rays to the light in double precision, and processor time of frames, over that of the same
// volume without shadows. All contestants draw one frame after the other, so that a noisy machine slows all of them;
// medians are printed.
//
//   BenchmarkShadows [cranium.vti] [--size pixels] [--error-size pixels] [--frames number]
//
// cranium.vti: a CT in Hounsfield units, in which bone begins at 200. Time is taken of frames in which the camera
// turns, and of frames in which the light does.

#include "BenchmarkOptions.h"
#include "FrameTimes.h"
#include "LightShadow.h"
#include "RayCaster.h"
#include "VTKVersion.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
struct Stage
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  std::vector<std::pair<double, double>> Opacities;
  double ToCamera[3];
  double Up[3];
  double ToLight[3];
  bool IsLamp;
};

struct Contestant
{
  std::string Name;
  bool IsOurs;
  bool HasShadows;
  int GridSize; // of ours
  bool Skips;   // empty space
};

vtkSmartPointer<vtkGPUVolumeRayCastMapper> MapperOf(const Contestant& contestant)
{
  if (contestant.IsOurs)
  {
    auto mapper = vtkSmartPointer<vtkOpticsVolumeMapper>::New();
    mapper->SetVisibilityGridSize(contestant.GridSize);
    mapper->SetSkipEmptySpace(contestant.Skips);
    return mapper;
  }
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
#ifdef VOLUMEOPTICS_VTK_HAS_VOLUMETRIC_SHADOWS
  if (contestant.HasShadows)
  {
    mapper->SetGlobalIlluminationReach(1.0F);
    mapper->SetVolumetricScatteringBlending(2.0F); // scattered light alone, as the model None
  }
#endif
  return mapper;
}

vtkSmartPointer<vtkOpticsVolumeProperty> PropertyOf(const Stage& stage, double voxel)
{
  auto property = vtkSmartPointer<vtkOpticsVolumeProperty>::New();
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& [scalar, value] : stage.Opacities)
  {
    opacity->AddPoint(scalar, value);
  }
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  property->SetScalarOpacity(opacity);
  property->SetColor(white);
  property->SetScalarOpacityUnitDistance(voxel);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  property->SetReflectanceModelToNone();
  return property;
}

// One window, mapper and volume.
class Theatre
{
public:
  Theatre(const Stage& stage, const Contestant& contestant)
    : Mapper(MapperOf(contestant))
  {
    const double* spacing = stage.Image->GetSpacing();
    const double voxel = std::min({ spacing[0], spacing[1], spacing[2] });
    this->Mapper->SetInputData(stage.Image);
    this->Mapper->SetAutoAdjustSampleDistances(0);
    this->Mapper->SetUseJittering(0);
    this->Mapper->SetSampleDistance(static_cast<float>(0.5 * voxel));
    vtkSmartPointer<vtkOpticsVolumeProperty> property = PropertyOf(stage, voxel);
    property->SetShadows(contestant.IsOurs && contestant.HasShadows);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->SetProperty(property);
    this->Renderer->AddVolume(this->Volume);
    this->Window->AddRenderer(this->Renderer);
    this->Light(stage);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(stage.ToCamera);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(stage.Up);
    this->Renderer->ResetCamera();
    camera->Zoom(1.4);
  }

  void Draw(int size)
  {
    this->Window->SetSize(size, size);
    this->Window->Render();
  }

  // A frame with the light or the camera turned by a degree.
  void Time(bool turnsLight)
  {
    if (turnsLight)
    {
      double* position = this->Lamp->GetPosition();
      const double angle = 0.02;
      this->Lamp->SetPosition(position[0] * std::cos(angle) - position[1] * std::sin(angle),
        position[0] * std::sin(angle) + position[1] * std::cos(angle), position[2]);
    }
    else
    {
      this->Renderer->GetActiveCamera()->Azimuth(1.0);
    }
    (turnsLight ? this->Relit : this->Turned).Draw(this->Window);
  }

  // The lower rows first; of one channel, as all are white.
  std::vector<double> GetPixels()
  {
    const int* size = this->Window->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.Get(), 0);
    std::vector<double> values(pixels->GetNumberOfTuples());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = pixels->GetComponent(static_cast<vtkIdType>(i), 0);
    }
    return values;
  }

  reference::Scene GetScene(int size)
  {
    return reference::SceneFromVTK(this->Renderer, this->Volume, size, size);
  }

  FrameTimes Turned, Relit;

private:
  // As far from the middle as the volume is long.
  void Light(const Stage& stage)
  {
    double center[3];
    stage.Image->GetCenter(center);
    const double length = stage.Image->GetLength();
    this->Lamp->SetLightTypeToSceneLight();
    this->Lamp->SetFocalPoint(center);
    this->Lamp->SetPosition(center[0] + length * stage.ToLight[0], center[1] + length * stage.ToLight[1],
      center[2] + length * stage.ToLight[2]);
    this->Lamp->SetPositional(stage.IsLamp);
    this->Lamp->SetConeAngle(180.0);
    this->Lamp->SetIntensity(0.9); // of 8 bits none is lost above
    this->Renderer->SetAutomaticLightCreation(false);
    this->Renderer->AddLight(this->Lamp);
  }

  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Lamp;
  vtkNew<vtkHeadlessRenderWindow> Window;
};

// In 255ths.
std::vector<double> Truth(Theatre& theatre, int size)
{
  reference::Scene scene = theatre.GetScene(size);
  scene.shadow = reference::LightShadow(scene, 0.0, 0.5 * scene.step, 1);
  std::vector<double> values;
  for (const auto& pixel : reference::Render(scene).pixels)
  {
    values.push_back(255.0 * std::min(pixel.r, 1.0));
  }
  return values;
}

struct Error
{
  double Mean = 0.0; // of the absolute difference, over the pixels where there is a volume
  double Bias = 0.0;
  double Worst = 0.0; // but for one of a hundred pixels
};

Error Compare(
  const std::vector<double>& values, const std::vector<double>& truth, const std::vector<double>& lit)
{
  Error error;
  std::vector<double> differences;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    if (lit[i] > 0.0)
    {
      differences.push_back(std::abs(values[i] - truth[i]));
      error.Mean += differences.back();
      error.Bias += values[i] - truth[i];
    }
  }
  const auto count = static_cast<double>(differences.size());
  error.Mean /= count;
  error.Bias /= count;
  std::sort(differences.begin(), differences.end());
  error.Worst = differences[differences.size() * 99 / 100];
  return error;
}

std::vector<Contestant> Contestants()
{
  std::vector<Contestant> all = { { "VTK without shadows", false, false, 0, false } };
#ifdef VOLUMEOPTICS_VTK_HAS_VOLUMETRIC_SHADOWS
  all.push_back({ "VTK's shadows", false, true, 0, false });
#endif
  all.push_back({ "None without shadows", true, false, 64, false });
  for (const int size : { 64, 128, 256 })
  {
    const std::string name = "sweep of " + std::to_string(size) + " froxels";
    all.push_back({ name, true, true, size, false });
    all.push_back({ name + ", skipping", true, true, size, true });
  }
  return all;
}

void Run(const Stage& stage, const BenchmarkOptions& options)
{
  const std::vector<Contestant> contestants = Contestants();
  std::vector<std::unique_ptr<Theatre>> theatres;
  std::vector<Error> errors;
  std::vector<double> lit, truth;
  for (const Contestant& contestant : contestants)
  {
    theatres.push_back(std::make_unique<Theatre>(stage, contestant));
    theatres.back()->Draw(options.Whole("--error-size"));
    const std::vector<double> values = theatres.back()->GetPixels();
    lit = lit.empty() ? values : lit;
    truth = truth.empty() ? Truth(*theatres.back(), options.Whole("--error-size")) : truth;
    errors.push_back(Compare(values, truth, lit));
    theatres.back()->Draw(options.Whole("--size"));
  }
  for (int frame = 0; frame < options.Whole("--frames"); ++frame)
  {
    for (auto& theatre : theatres)
    {
      theatre->Time(false);
      theatre->Time(true);
    }
  }
  for (std::size_t i = 0; i < theatres.size(); ++i)
  {
    std::printf("%s,%s,%.2f,%.2f,%.1f,%.1f,%.2f,%.2f\n", stage.Name.c_str(), contestants[i].Name.c_str(),
      errors[i].Mean, errors[i].Bias, errors[i].Worst, 1000.0 * theatres[i]->Turned.GetProcessorSeconds(),
      theatres[i]->Turned.GetRatio(theatres[0]->Turned), theatres[i]->Relit.GetRatio(theatres[0]->Relit));
  }
  std::fflush(stdout);
}

vtkSmartPointer<vtkImageData> Fill(int points, const std::function<double(const double*)>& density)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  const double spacing = 2.0 / (points - 1);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(spacing, spacing, spacing);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    static_cast<float*>(image->GetScalarPointer())[i] = static_cast<float>(density(image->GetPoint(i)));
  }
  return image;
}

// Inside 1, outside 0, over four voxels of a grid of 128.
double Soft(double inside)
{
  return std::clamp(0.5 + 16.0 * inside, 0.0, 1.0);
}

// Balls of several sizes over a floor.
double Balls(const double* p)
{
  const double balls[][4] = { { 0.0, 0.0, 0.1, 0.35 }, { 0.6, 0.3, -0.3, 0.2 }, { -0.5, 0.5, 0.3, 0.25 },
    { -0.55, -0.45, -0.2, 0.15 }, { 0.4, -0.6, 0.2, 0.1 } };
  double inside = -0.7 - p[2];
  for (const auto& ball : balls)
  {
    const double distance = std::hypot(p[0] - ball[0], p[1] - ball[1], p[2] - ball[2]);
    inside = std::max(inside, ball[3] - distance);
  }
  return Soft(inside);
}

// Rods across each other.
double Rods(const double* p)
{
  double inside = -0.8 - p[2];
  for (int i = -3; i <= 3; ++i)
  {
    inside = std::max(inside, 0.05 - std::hypot(p[0] - 0.27 * i, p[2] - 0.4));
    inside = std::max(inside, 0.05 - std::hypot(p[1] - 0.27 * i, p[2]));
  }
  return Soft(inside);
}
}

int main(int argc, char** argv)
{
  const BenchmarkOptions options(
    argc, argv, { { "--size", 256 }, { "--error-size", 96 }, { "--frames", 9 } });
  std::printf(
    "scene,contestant,mean error of 255,bias,99th percentile,ms when the camera turns,of VTK without "
    "shadows,the same when the light turns\n");
  const std::vector<std::pair<double, double>> dense = { { 0.0, 0.0 }, { 1.0, 0.8 } };
  const std::vector<std::pair<double, double>> thin = { { 0.0, 0.0 }, { 1.0, 0.1 } };
  for (const bool isLamp : { false, true })
  {
    const std::string light = isLamp ? ", lamp" : ", sun";
    Run({ "balls" + light, Fill(128, Balls), dense, { 0.5, -3.5, 2.5 }, { 0.0, 0.0, 1.0 }, { 0.5, -0.2, 0.7 },
          isLamp },
      options);
  }
  Run({ "transparent balls, sun", Fill(128, Balls), thin, { 0.5, -3.5, 2.5 }, { 0.0, 0.0, 1.0 },
        { 0.5, -0.2, 0.7 }, false },
    options);
  Run(
    { "rods, sun", Fill(128, Rods), dense, { 0.5, -3.5, 2.5 }, { 0.0, 0.0, 1.0 }, { 0.3, -0.4, 0.8 }, false },
    options);
  if (!options.GetWords().empty())
  {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(options.GetFile().c_str());
    reader->Update();
    Run({ "cranium, sun", reader->GetOutput(), { { 200.0, 0.0 }, { 600.0, 0.9 } }, { -0.5, 1.0, 0.3 },
          { 0.0, 0.0, 1.0 }, { 0.5, 0.6, 0.6 }, false },
      options);
  }
  return 0;
}
