// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of a frame with each reflectance model and with lighting transfer functions, over that of VTK's own mapper with shading. Frames of
// all kinds alternate, so that a noisy machine slows all of them; medians and their ratios are
// printed. Early ray termination is VTK's.
//
//   BenchmarkFrame [volume.vti [low high]] [--size pixels] [--frames number] [--step world length]
//
// Without a file: Marschner-Lobb, 128^3. low, high: where opacity begins and where it is 0.9.

#include "BenchmarkOptions.h"
#include "FrameContest.h"

#include "vtkLightingTransferFunction.h"

#include <cstdlib>
#include <iostream>

namespace
{
// Light on the boundary that opacity begins at; 3 to 9 fetches of the volume or the normals a sample.
void UseLightingTransferFunction(const ContestScene& scene, vtkOpticsVolumeProperty* property)
{
  vtkNew<vtkLightingTransferFunction> function;
  const double low = scene.Opacities.front().first, high = scene.Opacities.back().first;
  const double below[2] = { -1.0e4, low }, above[2] = { high, 1.0e4 };
  function->AddBoundary(below, above, 0.2, 0.7, 0.4);
  function->SetSoftness(0, high - low);
  property->SetLightingTransferFunction(function);
}

void AddLightingTransferFunctions(Contestants& all, const ContestScene& scene)
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
      [&](vtkOpticsVolumeProperty* property) { UseLightingTransferFunction(scene, property); }));
  }
}

Contestants MakeContestants(const ContestScene& scene)
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
  AddLightingTransferFunctions(all, scene);
  return all;
}
}

int main(int argc, char** argv)
{
  const BenchmarkOptions options(argc, argv, { { "--size", 512 }, { "--frames", 9 }, { "--step", 0.0 } });
  const std::vector<std::string>& words = options.GetWords();
  const double low = words.size() == 3 ? std::stod(words[1]) : 0.45;
  const double high = words.size() == 3 ? std::stod(words[2]) : 0.55;
  const ContestScene scene = { "", words.empty() ? MarschnerLobb() : ReadContestImage(options.GetFile()),
    { { low, 0.0 }, { high, 0.9 } }, true, options.Whole("--size"), options.Real("--step") };
  Contestants contestants = MakeContestants(scene);
  DrawInTurns(contestants, options.Whole("--frames"));
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
