// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of a frame without and with empty-space skipping, over that of VTK's own mapper, for scenes from almost empty
// to full, and for fog with as many holes as skipping is compiled in for: the worst that it can cost. Medians of
// ratios of processor time; the pictures are compared too.
//
//   BenchmarkEmptySpace [cranium.vti] [--size pixels] [--frames number] [--cell voxels] [--holes]
//
// cranium.vti: a CT in Hounsfield units, in which bone begins at 200. --holes: fog with holes alone.

#include "FrameContest.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

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
  bool OnlyHoles = false;
};

Options Read(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--holes")
    {
      options.OnlyHoles = true;
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

// Sees nothing below 0.5. Of the cells of `cell` voxels a share is empty: scattered, or those on one side.
vtkSmartPointer<vtkImageData> Fog(double share, bool isScattered, int cell)
{
  vtkSmartPointer<vtkImageData> image = MarschnerLobb();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int edge = image->GetDimensions()[0], cells = edge / cell;
  std::mt19937 random(1);
  std::vector<bool> isHole(static_cast<std::size_t>(cells) * cells * cells);
  for (std::size_t i = 0; i < isHole.size(); ++i)
  {
    isHole[i] = isScattered ? random() < share * 4294967296.0 : i < share * isHole.size();
  }
  // a cell sees one voxel more on each side
  const auto holeOf = [&](int voxel) { return voxel / cell; };
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const int x = static_cast<int>(i % edge), y = static_cast<int>(i / edge % edge),
              z = static_cast<int>(i / edge / edge);
    bool touchesHole = false;
    for (int corner = 0; corner < 27; ++corner)
    {
      const int place[3] = { x + corner % 3 - 1, y + corner / 3 % 3 - 1, z + corner / 9 - 1 };
      const int cx = std::clamp(holeOf(std::max(place[0], 0)), 0, cells - 1);
      const int cy = std::clamp(holeOf(std::max(place[1], 0)), 0, cells - 1);
      const int cz = std::clamp(holeOf(std::max(place[2], 0)), 0, cells - 1);
      touchesHole = touchesHole || isHole[(static_cast<std::size_t>(cz) * cells + cy) * cells + cx];
    }
    scalars->SetComponent(i, 0, touchesHole ? 0.0 : 1.0);
  }
  return image;
}
}

int main(int argc, char** argv)
{
  const Options options = Read(argc, argv);
  std::cout << "scene,shading,stock ms,off of stock,on of stock,on of off,terms,pictures\n";
  const vtkSmartPointer<vtkImageData> cranium =
    options.File.empty() ? nullptr : ReadContestImage(options.File);
  for (const ContestScene& scene : ContestScenes(cranium, options.Size))
  {
    if (!options.OnlyHoles)
    {
      CompareModels(scene, options);
    }
  }
  for (const double share : { 0.27, 0.36, 0.5, 0.85 })
  {
    for (const bool isScattered : { true, false })
    {
      const std::string name = "fog, " + std::to_string(static_cast<int>(100.0 * share)) +
        " % of the cells empty, " + (isScattered ? "scattered" : "on one side");
      CompareModels(
        { name, Fog(share, isScattered, options.Cell), { { 0.5, 0.0 }, { 0.9, 0.002 } }, true, options.Size },
        options);
    }
  }
  return EXIT_SUCCESS;
}
