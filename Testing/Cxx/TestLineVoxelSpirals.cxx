// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Spirals in perspective: above by the mapper, below by the evaluator in VTK's own mapper.

#include "LineTermScene.h"

#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkRegressionTestImage.h"

int TestLineVoxelSpirals(int argc, char* argv[])
{
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(40000);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(source->GetOutputPort());
  voxelizer->SetSampleDimensions(72, 72, 72);
  voxelizer->SetModelBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  voxelizer->SetRadius(0.003);
  vtkNew<vtkProperty> material;
  material->SetColor(1.0, 0.75, 0.4);
  material->SetSpecularColor(1.0, 1.0, 1.0);
  material->SetAmbient(0.15);
  material->SetDiffuse(0.85);
  material->SetSpecular(0.4);
  voxelizer->SetMaterial(0, material);
  voxelizer->SetSpecularPower(0, 32.0);
  LineTermScene scene(VoxelsOf(voxelizer), 300);
  scene.Mapper->SetSampleDistance(0.015F);
  scene.Camera->SetPosition(2.6, -1.6, 0.6);
  scene.Camera->SetViewAngle(38.0);
  scene.Renderer->SetViewport(0.0, 0.5, 1.0, 1.0);
  scene.Renderer->SetBackground(0.1, 0.1, 0.15);

  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
  evaluator->SetInputConnection(voxelizer->GetOutputPort());
  evaluator->SetCamera(scene.Camera);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputConnection(evaluator->GetOutputPort());
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(0.015F);
  mapper->SetUseJittering(0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  evaluator->SetUpVolume(volume);
  vtkNew<vtkRenderer> below;
  below->SetViewport(0.0, 0.0, 1.0, 0.5);
  below->SetBackground(0.1, 0.1, 0.15);
  below->SetActiveCamera(scene.Camera);
  below->AddVolume(volume);
  scene.Window->AddRenderer(below);
  scene.Window->Render();
  return vtkRegressionTestImage(scene.Window) == vtkRegressionTester::FAILED ? EXIT_FAILURE : EXIT_SUCCESS;
}
