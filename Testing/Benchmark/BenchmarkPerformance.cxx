// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The table of docs/performance.md, in Markdown: for each scene, the time of a frame of VTK's own mapper with shading,
// and that of each term over it. Medians of ratios of processor time, frames of all terms in turns.
//
//   BenchmarkPerformance [cranium.vti] [--size pixels] [--frames number] [--segments number]
//
// cranium.vti: a CT in Hounsfield units; without it, its two rows are left out. --segments: of the lines, whose row is
// over VTK's own picture of their tubes.

#include "BenchmarkOptions.h"
#include "FrameContest.h"

#include "vtkAnalyticLineSource.h"
#include "vtkAnisotropicLineVoxelizer.h"
#include "vtkAnisotropicVoxelEvaluator.h"
#include "vtkLightingTransferFunction.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkTubeFilter.h"

#include <cstdio>
#include <cstdlib>

namespace
{
// Light on the first slope of the opacity.
void UseLighting(const ContestScene& scene, vtkOpticsVolumeProperty* property)
{
  const double low = scene.Opacities.front().first, high = scene.Opacities[1].first;
  vtkNew<vtkLightingTransferFunction> function;
  const double below[2] = { -1.0e4, low }, above[2] = { high, 1.0e4 };
  function->AddBoundary(below, above, 0.2, 0.7, 0.4);
  function->SetSoftness(0, high - low);
  property->SetLightingTransferFunction(function);
}

struct Term
{
  const char* Name;
  bool Skips;
  std::function<void(const ContestScene&, vtkOpticsVolumeProperty*)> Use;
};

using Property = vtkOpticsVolumeProperty;
const Term Terms[] = {
  { "all off", false, [](const ContestScene&, Property*) {} },
  { "skipping", true, [](const ContestScene&, Property*) {} },
  { "Blinn-Phong", true, [](const ContestScene&, Property* p) { p->SetReflectanceModelToBlinnPhong(); } },
  { "Ward", true, [](const ContestScene&, Property* p) { p->SetReflectanceModelToWard(); } },
  { "Lafortune", true, [](const ContestScene&, Property* p) { p->SetReflectanceModelToLafortune(); } },
  { "lighting function", true, UseLighting },
  { "pre-integrated", true, [](const ContestScene&, Property* p) { p->SetClassificationToPreIntegrated(); } },
  { "data space", true, [](const ContestScene&, Property* p) { p->SetIntegrationSpaceToData(); } },
  { "occlusion", true, [](const ContestScene&, Property* p) { p->OcclusionOn(); } },
  { "shadows", true, [](const ContestScene&, Property* p) { p->ShadowsOn(); } },
};

void PrintHead()
{
  std::printf("| scene | stock, ms |");
  for (const Term& term : Terms)
  {
    std::printf(" %s |", term.Name);
  }
  std::printf("\n| --- | --- |");
  for (std::size_t i = 0; i < std::size(Terms); ++i)
  {
    std::printf(" --- |");
  }
  std::printf("\n");
}

void PrintScene(const ContestScene& scene, const BenchmarkOptions& options)
{
  Contestants all;
  all.push_back(
    std::make_unique<Contestant>("stock", scene, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New()));
  for (const Term& term : Terms)
  {
    vtkNew<vtkOpticsVolumeMapper> mapper;
    mapper->SetSkipEmptySpace(term.Skips);
    all.push_back(std::make_unique<Contestant>(
      term.Name, scene, mapper, [&](Property* property) { term.Use(scene, property); }));
  }
  DrawInTurns(all, options.Whole("--frames"));
  std::printf("| %s | %.0f |", scene.Name.c_str(), 1000.0 * all[0]->GetProcessorSeconds());
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    std::printf(" %.2f |", all[i]->GetRatio(*all[0]));
  }
  std::printf("\n");
  std::fflush(stdout);
}

// Spirals as tubes, as voxels that a filter evaluates for VTK's own mapper, and as voxels that ours evaluates.
void PrintLines(const BenchmarkOptions& options)
{
  const double radius = 0.004;
  vtkNew<vtkAnalyticLineSource> lines;
  lines->SetNumberOfSegments(options.Whole("--segments"));
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(lines->GetOutputPort());
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(6);
  vtkNew<vtkPolyDataMapper> polygons;
  polygons->SetInputConnection(tubes->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(polygons);

  const double bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(lines->GetOutputPort());
  voxelizer->SetSampleDimensions(128, 128, 128);
  voxelizer->SetModelBounds(bounds);
  voxelizer->SetRadius(radius);
  voxelizer->Update();
  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
  evaluator->SetInputConnection(voxelizer->GetOutputPort());
  vtkNew<vtkVolume> evaluated, drawn;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  stock->SetInputConnection(evaluator->GetOutputPort());
  vtkNew<vtkOpticsVolumeMapper> ours;
  ours->SetInputConnection(voxelizer->GetOutputPort());
  for (vtkGPUVolumeRayCastMapper* mapper : { static_cast<vtkGPUVolumeRayCastMapper*>(stock.Get()),
         static_cast<vtkGPUVolumeRayCastMapper*>(ours.Get()) })
  {
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetSampleDistance(1.0F / 128.0F);
  }
  evaluated->SetMapper(stock);
  evaluator->SetUpVolume(evaluated);
  drawn->SetMapper(ours);
  Contestants all;
  vtkNew<vtkCamera> still; // the filter is not run again for each view: the mapper alone
  still->SetPosition(0.4, 1.0, 0.3);
  evaluator->SetCamera(still);
  all.push_back(std::make_unique<Contestant>("tubes", actor, options.Whole("--size")));
  all.push_back(std::make_unique<Contestant>("evaluated", evaluated, options.Whole("--size")));
  all.push_back(std::make_unique<Contestant>("drawn", drawn, options.Whole("--size")));
  DrawInTurns(all, options.Whole("--frames"));
  std::printf(
    "\n| segments | tubes, ms | evaluated voxels, VTK's mapper, ms | our mapper over tubes | over VTK's "
    "mapper |\n| --- | --- | --- | --- | --- |\n| %d | %.0f | %.0f | %.2f | %.2f |\n",
    options.Whole("--segments"), 1000.0 * all[0]->GetProcessorSeconds(),
    1000.0 * all[1]->GetProcessorSeconds(), all[2]->GetRatio(*all[0]), all[2]->GetRatio(*all[1]));
}
}

int main(int argc, char** argv)
{
  const BenchmarkOptions options(
    argc, argv, { { "--size", 512 }, { "--frames", 9 }, { "--segments", 100000 } });
  const vtkSmartPointer<vtkImageData> cranium =
    options.GetWords().empty() ? nullptr : ReadContestImage(options.GetFile());
  PrintHead();
  for (const ContestScene& scene : ContestScenes(cranium, options.Whole("--size")))
  {
    PrintScene(scene, options);
  }
  PrintLines(options);
  return EXIT_SUCCESS;
}
