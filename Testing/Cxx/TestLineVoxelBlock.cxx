// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A finer block in place of a part of the lines, drawn by VTK's own mappers: as near to the same picture by
// vtkOpticsVolumeMapper as lines without a block are, wherever the eye is.

#include "LineTermScene.h"

#include "vtkOpenGLGPUVolumeRayCastMapper.h"

namespace
{
const double BlockBounds[6] = { -0.5, 0.4, -0.9, 0.3, -0.6, 0.5 };
const int BlockSize[3] = { 40, 52, 48 };
// The evaluator's image of the block begins in the middle of its first voxels. The half of a voxel around it is 6 % of
// the block, on each of its sides; of what is seen it is twice as much, since the foremost lines hide others.
const double Rim = 0.13;

vtkSmartPointer<vtkImageData> MakeVoxels(int x, int y, int z, const double bounds[6], double red)
{
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(8000);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(source->GetOutputPort());
  voxelizer->SetSampleDimensions(x, y, z);
  voxelizer->SetModelBounds(const_cast<double*>(bounds));
  voxelizer->SetRadius(0.02);
  vtkNew<vtkProperty> material;
  material->SetColor(red, 0.6, 1.0 - red);
  voxelizer->SetMaterial(0, material);
  return VoxelsOf(voxelizer);
}

// Voxels as VTK draws them.
struct StockVolume
{
  StockVolume(vtkAnisotropicVoxelEvaluator* evaluator)
  {
    this->Mapper->SetInputConnection(evaluator->GetOutputPort());
    this->Mapper->SetAutoAdjustSampleDistances(0);
    this->Mapper->SetSampleDistance(0.02F);
    this->Mapper->SetUseJittering(0);
    this->Volume->SetMapper(this->Mapper);
    evaluator->SetUpVolume(this->Volume);
  }
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Volume;
};

double MeanDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double sum = 0.0, covered = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const bool isColor = i % 4 != 3;
    sum += isColor ? std::abs(double(a[i]) - b[i]) : 0.0;
    covered += isColor && (a[i] > 0.0F || b[i] > 0.0F) ? 1.0 : 0.0;
  }
  return sum / std::max(covered, 1.0);
}

void Compare(Check& check)
{
  const double all[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  const auto coarse = MakeVoxels(32, 32, 32, all, 0.1);
  const auto fine = MakeVoxels(BlockSize[0], BlockSize[1], BlockSize[2], BlockBounds, 1.0);
  LineTermScene scene(coarse);
  scene.Mapper->SetSampleDistance(0.02F);
  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator, ofBlock;
  evaluator->SetInputData(coarse);
  ofBlock->SetInputData(fine);
  for (vtkAnisotropicVoxelEvaluator* one : { evaluator.Get(), ofBlock.Get() })
  {
    one->SetCamera(scene.Camera);
  }
  StockVolume behind(evaluator), block(ofBlock), inFront(evaluator);
  const std::vector<vtkVolume*> withBlock = { behind.Volume, block.Volume, inFront.Volume };
  const auto draw = [&](const std::vector<vtkVolume*>& volumes) {
    scene.Renderer->RemoveAllViewProps();
    for (vtkVolume* volume : volumes)
    {
      scene.Renderer->AddVolume(volume);
    }
    return scene.RenderFloat();
  };
  evaluator->CropAroundBlock(fine, behind.Mapper, inFront.Mapper);
  const glm::dvec3 positions[] = { { 1.5, -4.0, 2.0 }, { 0.1, 4.0, 0.2 }, { -4.0, -0.2, -3.0 },
    { 0.0, -0.3, 0.1 } }; // the last one in the block
  for (int i = 0; i < 5; ++i)
  {
    const std::string view = "view " + std::to_string(i);
    scene.Camera->SetPosition(&positions[i % 4].x);
    scene.Camera->SetParallelProjection(i == 4);
    scene.Camera->SetParallelScale(1.2);
    scene.Camera->SetClippingRange(0.1, 10.0);
    scene.Mapper->SetLineBlockInputConnection(nullptr);
    const auto plainMapper = draw({ scene.Volume });
    scene.Mapper->SetLineBlockInputData(fine);
    const auto blockMapper = draw({ scene.Volume });
    const auto blockStock = draw(withBlock);
    evaluator->CropAroundBlock(nullptr, nullptr, nullptr);
    const auto plainStock = draw({ behind.Volume });
    evaluator->CropAroundBlock(fine, behind.Mapper, inFront.Mapper);
    const double without = MeanDifference(plainMapper, plainStock);
    const double with = MeanDifference(blockMapper, blockStock);
    const double changed = MeanDifference(blockMapper, plainMapper);
    std::cout << view << ": " << with << ", without a block " << without << ", changed " << changed
              << std::endl;
    check.AtMost(view, with, 1.2 * without + Rim * changed);
    check.AtLeast(view + ", what the block changes", changed, 0.03);
  }
}
}

int TestLineVoxelBlock(int, char*[])
{
  Check check;
  Compare(check);
  return check.ExitCode();
}
