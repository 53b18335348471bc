// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of a frame with each reflectance model and with lighting transfer functions, over that of VTK's own mapper with shading. Frames of
// all kinds alternate, so that a noisy machine slows all of them; medians and their ratios are
// printed. Early ray termination is VTK's.
//
//   BenchmarkFrame [volume.vti [low high]] [--size pixels] [--frames number] [--step world length]
//
// Without a file: Marschner-Lobb, 128^3. low, high: where opacity begins and where it is 0.9.

#include "FrameContest.h"

#include "vtkLightingTransferFunction.h"

#include <cstdlib>
#include <iostream>

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

// Light on the boundary that opacity begins at; 3 to 9 fetches of the volume or the normals a sample.
void UseLightingTransferFunction(const Options& options, vtkOpticsVolumeProperty* property)
{
  vtkNew<vtkLightingTransferFunction> function;
  const double below[2] = { -1.0e4, options.Low }, above[2] = { options.High, 1.0e4 };
  function->AddBoundary(below, above, 0.2, 0.7, 0.4);
  function->SetSoftness(0, options.High - options.Low);
  property->SetLightingTransferFunction(function);
}

void AddLightingTransferFunctions(Contestants& all, const ContestScene& scene, const Options& options)
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
    mapper->SetScalarGradient(kind.Gradient);
    mapper->SetLightingSamples(kind.Samples);
    all.push_back(std::make_unique<Contestant>(kind.Name, scene, mapper,
      [&](vtkOpticsVolumeProperty* property) { UseLightingTransferFunction(options, property); }));
  }
}

Contestants MakeContestants(const ContestScene& scene, const Options& options)
{
  using Property = vtkOpticsVolumeProperty;
  Contestants all;
  all.push_back(std::make_unique<Contestant>(
    "stock VTK, ShadeOn", scene, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New()));
  const std::pair<const char*, int> models[] = { { "every term off", Property::VTK },
    { "None", Property::None }, { "Blinn-Phong", Property::BlinnPhong }, { "Ward", Property::Ward },
    { "Lafortune", Property::Lafortune } };
  for (const auto& [name, number] : models)
  {
    const int model = number;
    all.push_back(std::make_unique<Contestant>(name, scene, vtkSmartPointer<vtkOpticsVolumeMapper>::New(),
      [=](Property* property) { property->SetReflectanceModel(model); }));
  }
  AddLightingTransferFunctions(all, scene, options);
  return all;
}
}

int main(int argc, char** argv)
{
  const Options options = Read(argc, argv);
  const ContestScene scene = { "", options.File.empty() ? MarschnerLobb() : ReadContestImage(options.File),
    { { options.Low, 0.0 }, { options.High, 0.9 } }, true, options.Size, options.Step };
  Contestants contestants = MakeContestants(scene, options);
  DrawInTurns(contestants, options.Frames);
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
