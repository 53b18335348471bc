// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of a frame without and with empty-space skipping, over that of VTK's own mapper, for scenes from almost empty
// to full, for scenes whose gradient opacity hides what is homogeneous, and for fog with as many holes as skipping is compiled in for: the worst that it can cost. Medians of
// ratios of processor time; the pictures are compared too.
//
//   BenchmarkEmptySpace [cranium.vti] [--size pixels] [--frames number] [--cell voxels] [--holes | --gradients]
//
// cranium.vti: a CT in Hounsfield units, in which bone begins at 200. --holes: fog with holes alone;
// --gradients: scenes with a gradient opacity alone.

#include "FrameContest.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace
{
struct Options
{
  std::string File;
  int Size = 512;
  int Frames = 9;
  int Cell = 0;
  std::string Only; // --holes or --gradients
};

Options Read(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--holes" || word == "--gradients")
    {
      options.Only = word;
    }
    else if (word.substr(0, 2) != "--")
    {
      options.File = word;
    }
    else
    {
      int& number = word == "--size" ? options.Size : word == "--frames" ? options.Frames : options.Cell;
      number = i + 1 < argc ? std::stoi(argv[++i]) : number;
    }
  }
  return options;
}

void Compare(const ContestScene& scene, const std::string& kind, int model, const Options& options)
{
  vtkNew<vtkOpticsVolumeMapper> off, on;
  off->SkipEmptySpaceOff();
  on->SetMacrocellSize(options.Cell);
  const auto useModel = [&](vtkOpticsVolumeProperty* property) { property->SetReflectanceModel(model); };
  Contestants all;
  all.push_back(
    std::make_unique<Contestant>("stock", scene, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New()));
  all.push_back(std::make_unique<Contestant>("off", scene, off, useModel));
  all.push_back(std::make_unique<Contestant>("on", scene, on, useModel));
  DrawInTurns(all, options.Frames);
  std::cout << '"' << scene.Name << "\"," << kind << "," << 1000.0 * all[0]->GetProcessorSeconds() << ","
            << all[1]->GetRatio(*all[0]) << "," << all[2]->GetRatio(*all[0]) << ","
            << all[2]->GetRatio(*all[1]) << "," << on->GetActiveTerms() << ","
            << (all[1]->GetPixels() == all[2]->GetPixels() ? "identical" : "different") << std::endl;
}

// Drawn three ways: not shaded, as VTK shades, and by Ward's model.
void CompareModels(ContestScene scene, const Options& options)
{
  scene.IsShaded = false;
  Compare(scene, "unshaded", vtkOpticsVolumeProperty::VTK, options);
  scene.IsShaded = true;
  Compare(scene, "shaded", vtkOpticsVolumeProperty::VTK, options);
  Compare(scene, "Ward", vtkOpticsVolumeProperty::Ward, options);
}

using Cell = std::array<int, 3>;
using IsHole = std::function<bool(const Cell&)>;

// Sees nothing below 0.5. Holes of `edge` voxels: what a cell there sees, one voxel more on each side, is empty, too.
vtkSmartPointer<vtkImageData> Fog(int edge, const IsHole& isHole)
{
  vtkSmartPointer<vtkImageData> image = MarschnerLobb();
  const int size = image->GetDimensions()[0];
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    bool touchesHole = false;
    for (int corner = 0; corner < 27 && !touchesHole; ++corner)
    {
      const auto cellOf = [&](vtkIdType voxel, int offset) {
        return std::clamp(static_cast<int>(voxel) + offset, 0, size - 1) / edge;
      };
      touchesHole = isHole({ cellOf(i % size, corner % 3 - 1), cellOf(i / size % size, corner / 3 % 3 - 1),
        cellOf(i / size / size, corner / 9 - 1) });
    }
    image->GetPointData()->GetScalars()->SetComponent(i, 0, touchesHole ? 0.0 : 1.0);
  }
  return image;
}

struct Shape
{
  std::string Name;
  IsHole Has;
};

// Of holes on a grid of `cells` on each axis.
std::vector<Shape> Shapes(int cells)
{
  std::vector<Shape> shapes;
  const auto index = [=](const Cell& cell) { return (cell[2] * cells + cell[1]) * cells + cell[0]; };
  for (const double share : { 0.12, 0.27, 0.36, 0.5, 0.85 })
  {
    const std::string percent = std::to_string(static_cast<int>(100.0 * share)) + " % empty, ";
    const double count = share * cells * cells * cells;
    std::vector<bool> isHole(static_cast<std::size_t>(cells) * cells * cells);
    std::mt19937 random(1);
    std::generate(isHole.begin(), isHole.end(), [&]() { return random() < share * 4294967296.0; });
    shapes.push_back({ percent + "scattered", [=](const Cell& cell) { return isHole[index(cell)]; } });
    shapes.push_back({ percent + "on one side", [=](const Cell& cell) { return index(cell) < count; } });
  }
  shapes.push_back({ "slabs, every second one empty", [](const Cell& cell) { return cell[2] % 2 == 0; } });
  shapes.push_back({ "slabs, every fourth one empty", [](const Cell& cell) { return cell[2] % 4 == 0; } });
  shapes.push_back(
    { "checkerboard", [](const Cell& cell) { return (cell[0] + cell[1] + cell[2]) % 2 == 0; } });
  shapes.push_back({ "shells, every third one empty", [=](const Cell& cell) {
                      const double x = cell[0] - 0.5 * cells, y = cell[1] - 0.5 * cells,
                                   z = cell[2] - 0.5 * cells;
                      return static_cast<int>(std::sqrt(x * x + y * y + z * z)) % 3 == 0;
                    } });
  return shapes;
}

void CompareHoles(const Options& options)
{
  for (const int edge : { 4, 8 })
  {
    for (const Shape& shape : Shapes(128 / edge))
    {
      const std::string name = "fog; holes of " + std::to_string(edge) + " voxels; " + shape.Name;
      CompareModels(
        { name, Fog(edge, shape.Has), { { 0.5, 0.0 }, { 0.9, 0.002 } }, true, options.Size }, options);
    }
  }
}

// Tissue within its boundaries is hidden. Without the gradient opacity all of it is seen.
std::vector<ContestScene> GradientScenes(vtkImageData* cranium, int size)
{
  std::vector<ContestScene> scenes;
  if (cranium)
  {
    scenes.push_back(
      { "cranium, boundaries of tissue", cranium, { { -500.0, 0.0 }, { -300.0, 0.1 }, { 500.0, 0.3 } }, true,
        size, 0.0, { { 0.0, 0.0 }, { 100.0, 0.0 }, { 300.0, 1.0 } } });
    scenes.push_back({ "cranium, boundaries of air, too", cranium, { { -1024.0, 0.1 }, { 500.0, 0.3 } }, true,
      size, 0.0, { { 0.0, 0.0 }, { 100.0, 0.0 }, { 300.0, 1.0 } } });
  }
  scenes.push_back({ "Marschner-Lobb, the steepest places", MarschnerLobb(), { { 0.0, 0.1 }, { 1.0, 0.3 } },
    true, size, 0.0, { { 0.0, 0.0 }, { 0.08, 0.0 }, { 0.09, 1.0 } } });
  return scenes;
}
}

int main(int argc, char** argv)
{
  const Options options = Read(argc, argv);
  std::cout << "scene,shading,stock ms,off of stock,on of stock,on of off,terms,pictures\n";
  const vtkSmartPointer<vtkImageData> cranium =
    options.File.empty() ? nullptr : ReadContestImage(options.File);
  std::vector<ContestScene> scenes = ContestScenes(cranium, options.Size);
  scenes.push_back({ "Marschner-Lobb, half of it solid", MarschnerLobb(), { { 0.5, 0.0 }, { 0.52, 0.9 } },
    true, options.Size });
  if (!options.Only.empty())
  {
    scenes.clear();
  }
  if (options.Only != "--holes")
  {
    const std::vector<ContestScene> more = GradientScenes(cranium, options.Size);
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  for (const ContestScene& scene : scenes)
  {
    CompareModels(scene, options);
  }
  if (options.Only != "--gradients")
  {
    CompareHoles(options);
  }
  return EXIT_SUCCESS;
}
