// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The evaluator's RGBA in VTK's own mapper: opacity and colour of a uniform bundle as the closed form says, no
// dark rim, per block as per voxel, transfer function and scales.

#include "FloatTarget.h"
#include "LineTesting.h"
#include "Optics.h"
#include "WindowPixels.h"

#include "vtkAnalyticLineSource.h"
#include "vtkCamera.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
struct Scene
{
  vtkNew<vtkAnisotropicLineVoxelizer> Voxelizer;
  vtkNew<vtkAnisotropicVoxelEvaluator> Evaluator;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window = vtkSmartPointer<vtkRenderWindow>::New();

  Scene()
  {
    this->Evaluator->SetInputConnection(this->Voxelizer->GetOutputPort());
    this->Evaluator->SetCamera(this->Renderer->GetActiveCamera());
    this->Mapper->SetInputConnection(this->Evaluator->GetOutputPort());
    this->Mapper->SetAutoAdjustSampleDistances(0);
    this->Mapper->SetUseJittering(0);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->SetProperty(this->Property);
    this->Renderer->AddVolume(this->Volume);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(150, 150);
    this->Window->AddRenderer(this->Renderer);
  }

  bool MarksRange = false; // instead of the mapper's native range

  std::vector<unsigned char> Render()
  {
    this->Evaluator->SetUpVolume(this->Volume);
    this->Evaluator->SetMarkOpacityRange(this->MarksRange);
    this->Mapper->SetScalarOpacityRangeType(
      this->MarksRange ? vtkGPUVolumeRayCastMapper::SCALAR : vtkGPUVolumeRayCastMapper::NATIVE);
    return RenderPixels(this->Window);
  }
};

glm::dvec3 PixelAt(const std::vector<unsigned char>& pixels, int x, int y)
{
  const unsigned char* pixel = &pixels[3 * (150 * y + x)];
  return glm::dvec3(pixel[0], pixel[1], pixel[2]) / 255.0;
}

// Of a voxel that is crossed along an edge, 1.5 times its mean chord, with .2 of its face covered.
const double Depth = 1.5 * optics::MeanDepthOfShare(0.2 / 1.5) / (TwoPi / 8.0);

// On the CPU, of bytes; and by the mapper that chooses one, of the opaque voxel that marks the range, beside the middle.
void CheckOtherMappers(Check& check, Scene& scene, double through)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> onCPU;
  onCPU->SetAutoAdjustSampleDistances(0);
  onCPU->SetSampleDistance(0.05F);
  vtkNew<vtkSmartVolumeMapper> smart;
  smart->SetAutoAdjustSampleDistances(0);
  smart->SetSampleDistance(0.05F);
  smart->SetRequestedRenderModeToGPU();
  const int type = scene.Evaluator->GetOutputScalarType();
  for (vtkVolumeMapper* mapper :
    { static_cast<vtkVolumeMapper*>(smart), static_cast<vtkVolumeMapper*>(onCPU) })
  {
    mapper->SetInputConnection(scene.Evaluator->GetOutputPort());
    scene.Volume->SetMapper(mapper);
    scene.Evaluator->SetUpVolume(scene.Volume);
    const auto pixels = RenderPixels(scene.Window);
    check.Near(mapper->GetClassName(), PixelAt(pixels, 75, 60).y, through, 0.03);
  }
  check.That(scene.Evaluator->GetOutputScalarType() == VTK_UNSIGNED_CHAR, "no bytes on the CPU");
  scene.Evaluator->SetOutputScalarType(type);
  scene.Volume->SetMapper(scene.Mapper);
}

// Lines along x, one in each voxel of a slab n voxels thick, on white: of the light behind, exp(-sum tau)
// comes through.
void CheckOpacity(Check& check)
{
  Scene scene;
  const int n = 12;
  std::vector<lines::Line> all;
  for (int y = 2; y < n - 2; ++y)
  {
    for (int z = 3; z < n - 3; ++z)
    {
      all.push_back({ { 2.0, y + 0.5, z + 0.5 }, { n - 2.0, y + 0.5, z + 0.5 } });
    }
  }
  vtkNew<vtkProperty> material;
  material->SetDiffuse(0.0);
  material->SetAmbient(1.0);
  material->SetColor(1.0, 0.0, 0.0);
  scene.Voxelizer->SetMaterial(0, material);
  scene.Voxelizer->SetInputData(lines::MakeLines(all));
  scene.Voxelizer->SetSampleDimensions(n, n, n);
  scene.Voxelizer->SetModelBounds(0.0, n, 0.0, n, 0.0, n);
  scene.Voxelizer->SetRadius(0.1);
  scene.Voxelizer->SetMaximumOrder(8);
  scene.Mapper->SetSampleDistance(0.05F);
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(n / 2.0, n / 2.0, n / 2.0);
  camera->SetPosition(n / 2.0, n / 2.0, 50.0);
  camera->SetParallelScale(n / 2.0);
  for (int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_FLOAT })
  {
    scene.Evaluator->SetOutputScalarType(type);
    scene.Renderer->ResetCameraClippingRange();
    const glm::dvec3 middle = PixelAt(scene.Render(), 75, 75);
    const double through = std::exp(-6.0 * Depth);
    check.Near("red", middle.x, 1.0, 0.01);
    check.Near("green: what comes through", middle.y, through, 0.02);
    // towards the rims it must be red over white everywhere: nothing darker
    const auto pixels = scene.Render();
    double least = 1.0;
    for (std::size_t i = 0; i < pixels.size(); i += 3)
    {
      least = std::min(least, pixels[i] / 255.0);
    }
    check.AtLeast("no dark rim", least, 0.985);
  }
  CheckOtherMappers(check, scene, std::exp(-6.0 * Depth));
  scene.MarksRange = true;
  const auto marked = scene.Render();
  check.Near("marked range", PixelAt(marked, 75, 60).y, std::exp(-6.0 * Depth), 0.03);
  scene.MarksRange = false;
  scene.Evaluator->SetRadiusScale(0, 2.0);
  check.Near("radius scale", PixelAt(scene.Render(), 75, 75).y, std::exp(-12.0 * Depth), 0.02);
  scene.Evaluator->SetRadiusScale(0, 1.0);
  scene.Evaluator->SetOpacityScale(0, 0.5);
  check.Near("opacity scale", PixelAt(scene.Render(), 75, 75).y,
    std::pow(1.0 - 0.5 * (1.0 - std::exp(-Depth / 1.5)), 6.0 * 1.5), 0.02);
  scene.Evaluator->SetOpacityScale(0, 1.0);
  vtkNew<vtkPiecewiseFunction> none;
  none->AddPoint(0.0, 0.0);
  none->AddPoint(1.0, 0.0);
  scene.Evaluator->SetOpacityFunction(none);
  check.Near("opacity function", PixelAt(scene.Render(), 75, 75).y, 1.0, 0.0);
}

// One line among empty voxels: the optical depth, summed over the picture, is that of its voxels times a quarter of
// their surface, however it is interpolated. Opacities of a quarter of the chord, in place of depths, lose less than 3 % of the
// thick line (those of the whole chord 12 %), VTK's table of 8000 opacities less of the thin one (of 1024, 10 %: half of
// an entry of the mean depth .02).
void CheckExtinction(Check& check)
{
  Scene scene;
  const int n = 16;
  scene.Voxelizer->SetInputData(lines::MakeLines({ { { 2.2, 6.1, 7.3 }, { 13.6, 9.4, 8.8 } } }));
  scene.Voxelizer->SetSampleDimensions(n, n, n);
  scene.Voxelizer->SetModelBounds(0.0, n, 0.0, n, 0.0, n);
  scene.Mapper->SetSampleDistance(0.1F);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(n / 2.0, n / 2.0, n / 2.0);
  camera->SetPosition(n / 2.0, n / 2.0, 50.0);
  camera->SetParallelScale(n / 2.0);
  for (double radius : { 0.05, 0.25 })
  {
    scene.Voxelizer->SetRadius(radius);
    scene.Evaluator->SetUpVolume(scene.Volume);
    scene.Renderer->ResetCameraClippingRange();
    const std::vector<float> pixels = RenderFloat(scene.Window, scene.Renderer);
    double drawn = 0.0, wanted = 0.0;
    for (std::size_t i = 3; i < pixels.size(); i += 4)
    {
      drawn -= std::log1p(-double(pixels[i])) * (n / 150.0) * (n / 150.0);
    }
    const vtkIdType voxels = lines::CountOf(scene.Voxelizer->GetOutput(), "LineType0_Places");
    for (vtkIdType v = 0; v < voxels; ++v)
    {
      wanted += 1.5 * lines::Look(scene.Voxelizer->GetOutput(), { 0.0, 0.0, 1.0 }, v).Depth;
    }
    check.Near("extinction of a line of radius " + std::to_string(radius), drawn / wanted, 1.0, 0.03);
  }
}

// In perspective, one direction a block is near one a voxel.
void CheckBlocks(Check& check)
{
  Scene scene;
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(20000);
  scene.Voxelizer->SetInputConnection(source->GetOutputPort());
  scene.Voxelizer->SetSampleDimensions(64, 64, 64);
  scene.Mapper->SetSampleDistance(0.02F);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(2.0, -4.0, 2.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Render();
  scene.Renderer->ResetCamera();
  const auto perVoxel = scene.Render();
  scene.Evaluator->SetViewDirectionsToPerBlock();
  const auto perBlock = scene.Render();
  double sum = 0.0, brightest = 0.0;
  for (std::size_t i = 0; i < perVoxel.size(); ++i)
  {
    sum += std::abs(perVoxel[i] - perBlock[i]);
    brightest = std::max<double>(brightest, perVoxel[i]);
  }
  check.AtMost("per block, codes", sum / perVoxel.size(), 0.5);
  check.AtLeast("per block differs", sum, 1.0);
  check.AtLeast("lines are bright", brightest, 100.0);
  camera->Azimuth(40.0);
  check.That(scene.Render() != perBlock, "a moved camera is evaluated again");
}
}

int TestLineVoxelPictures(int, char*[])
{
  Check check;
  CheckOpacity(check);
  CheckExtinction(check);
  CheckBlocks(check);
  return check.ExitCode();
}
