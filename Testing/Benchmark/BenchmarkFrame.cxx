// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of a frame with each reflectance model and with lighting transfer functions, over that of VTK's own mapper with shading. Frames of
// all kinds alternate, so that a noisy machine slows all of them; medians and their ratios are
// printed. Early ray termination is VTK's.
//
//   BenchmarkFrame [volume.vti [low high]] [--size pixels] [--frames number] [--step world length]
//
// Without a file: Marschner-Lobb, 128^3. low, high: where opacity begins and where it is 0.9.

#include "vtkAnalyticVolumeSource.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkLightingTransferFunction.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
struct Options
{
  std::string File;
  double Low = 0.45;
  double High = 0.55;
  int Size = 512;
  int Frames = 9;
  double Step = 0.0; // half the smallest spacing
};

Options Read(int argc, char** argv)
{
  Options options;
  std::vector<std::string> plain;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const std::string next = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--size")
    {
      options.Size = std::stoi(next);
    }
    else if (word == "--frames")
    {
      options.Frames = std::stoi(next);
    }
    else if (word == "--step")
    {
      options.Step = std::stod(next);
    }
    else
    {
      plain.push_back(word);
      continue;
    }
    ++i;
  }
  if (!plain.empty())
  {
    options.File = plain[0];
  }
  if (plain.size() == 3)
  {
    options.Low = std::stod(plain[1]);
    options.High = std::stod(plain[2]);
  }
  return options;
}

vtkSmartPointer<vtkImageData> Load(const Options& options)
{
  if (options.File.empty())
  {
    vtkNew<vtkAnalyticVolumeSource> source;
    source->SetDimensions(128, 128, 128);
    source->Update();
    return source->GetOutput();
  }
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(options.File.c_str());
  reader->Update();
  return reader->GetOutput();
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// One window, mapper and volume of one kind.
class Contestant
{
public:
  Contestant(std::string name, vtkGPUVolumeRayCastMapper* mapper, int model)
    : Name(std::move(name))
    , Mapper(mapper)
  {
    this->Property->SetReflectanceModel(model);
  }

  // Light on the boundary that opacity begins at; 3 to 9 fetches of the volume or the normals a sample.
  void UseLightingTransferFunction(
    const Options& options, vtkOpticsVolumeMapper* mapper, int gradient, int samples)
  {
    vtkNew<vtkLightingTransferFunction> function;
    const double below[2] = { -1.0e4, options.Low }, above[2] = { options.High, 1.0e4 };
    function->AddBoundary(below, above, 0.2, 0.7, 0.4);
    function->SetSoftness(0, options.High - options.Low);
    this->Property->SetLightingTransferFunction(function);
    mapper->SetScalarGradient(gradient);
    mapper->SetLightingSamples(samples);
  }

  void SetUp(vtkImageData* image, const Options& options)
  {
    const double* spacing = image->GetSpacing();
    const double step = std::min({ spacing[0], spacing[1], spacing[2] }) / 2.0;
    this->Mapper->SetInputData(image);
    this->Mapper->SetAutoAdjustSampleDistances(0);
    this->Mapper->SetUseJittering(0);
    this->Mapper->SetSampleDistance(static_cast<float>(options.Step > 0.0 ? options.Step : step));
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(options.Low, 0.0);
    opacity->AddPoint(options.High, 0.9);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(options.Low, 0.8, 0.7, 0.6);
    this->Property->SetScalarOpacity(opacity);
    this->Property->SetColor(color);
    this->Property->SetScalarOpacityUnitDistance(2.0 * step);
    this->Property->SetInterpolationTypeToLinear();
    this->Property->ShadeOn();
    vtkNew<vtkVolume> volume;
    volume->SetMapper(this->Mapper);
    volume->SetProperty(this->Property);
    vtkNew<vtkRenderer> renderer;
    renderer->AddVolume(volume);
    this->Window->SetSize(options.Size, options.Size);
    this->Window->AddRenderer(renderer);
    renderer->GetActiveCamera()->SetPosition(0.4, 1.0, 0.3);
    renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCamera();
    renderer->GetActiveCamera()->Zoom(1.5);
    this->Window->Render(); // uploads, links, estimates frames
  }

  void Draw()
  {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t clockBegin = std::clock();
    this->Window->Render();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    this->Seconds.push_back(elapsed.count());
    this->ProcessorSeconds.push_back(static_cast<double>(std::clock() - clockBegin) / CLOCKS_PER_SEC);
  }

  double GetSeconds() const { return Median(this->Seconds); }
  double GetProcessorSeconds() const { return Median(this->ProcessorSeconds); }

  std::string Name;

private:
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkOpticsVolumeProperty> Property;
  vtkNew<vtkHeadlessRenderWindow> Window;
  std::vector<double> Seconds;
  std::vector<double> ProcessorSeconds;
};

void AddLightingTransferFunctions(std::vector<std::unique_ptr<Contestant>>& all, const Options& options)
{
  using Mapper = vtkOpticsVolumeMapper;
  const struct
  {
    const char* Name;
    int Gradient, Samples;
  } kinds[] = { { "lighting by default", Mapper::Automatic, Mapper::Fetched },
    { "lighting by a stored gradient and extrapolation", Mapper::Stored, Mapper::Extrapolated },
    { "lighting by a gradient on the fly", Mapper::CentralDifferences, Mapper::Fetched },
    { "lighting by a gradient on the fly and extrapolation", Mapper::CentralDifferences,
      Mapper::Extrapolated } };
  for (const auto& kind : kinds)
  {
    vtkNew<Mapper> mapper;
    all.push_back(std::make_unique<Contestant>(kind.Name, mapper, vtkOpticsVolumeProperty::VTK));
    all.back()->UseLightingTransferFunction(options, mapper, kind.Gradient, kind.Samples);
  }
}

std::vector<std::unique_ptr<Contestant>> MakeContestants(const Options& options)
{
  using Property = vtkOpticsVolumeProperty;
  std::vector<std::unique_ptr<Contestant>> all;
  all.push_back(std::make_unique<Contestant>(
    "stock VTK, ShadeOn", vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New(), Property::VTK));
  const std::pair<const char*, int> models[] = { { "every term off", Property::VTK },
    { "None", Property::None }, { "Blinn-Phong", Property::BlinnPhong }, { "Ward", Property::Ward },
    { "Lafortune", Property::Lafortune } };
  for (const auto& [name, model] : models)
  {
    all.push_back(std::make_unique<Contestant>(name, vtkSmartPointer<vtkOpticsVolumeMapper>::New(), model));
  }
  AddLightingTransferFunctions(all, options);
  return all;
}
}

int main(int argc, char** argv)
{
  const Options options = Read(argc, argv);
  vtkSmartPointer<vtkImageData> image = Load(options);
  auto contestants = MakeContestants(options);
  for (auto& contestant : contestants)
  {
    contestant->SetUp(image, options);
  }
  for (int frame = 0; frame < options.Frames; ++frame)
  {
    for (auto& contestant : contestants)
    {
      contestant->Draw();
    }
  }
  const Contestant& stock = *contestants.front();
  std::cout << "model,wall ms,of stock,processor ms,of stock\n";
  for (const auto& contestant : contestants)
  {
    const double wall = contestant->GetSeconds(), processor = contestant->GetProcessorSeconds();
    std::cout << contestant->Name << "," << 1000.0 * wall << "," << wall / stock.GetSeconds() << ","
              << 1000.0 * processor << "," << processor / stock.GetProcessorSeconds() << "\n";
  }
  return EXIT_SUCCESS;
}
