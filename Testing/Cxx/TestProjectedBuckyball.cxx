// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A buckyball of 148,955 tetrahedra with two isosurfaces: left as the integral is, right with silhouettes.

#include "BuckyballScene.h"
#include "vtkDataSpaceProjectedTetrahedraMapper.h"

#include "vtkCamera.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <iostream>

namespace
{
void AddView(vtkRenderWindow* window, vtkUnstructuredGrid* grid, bool hasSilhouettes)
{
  vtkNew<vtkDataSpaceProjectedTetrahedraMapper> mapper;
  mapper->SetInputData(grid);
  vtkNew<vtkOpticsVolumeProperty> property;
  buckyball::SetFunctions(property);
  property->AddIsosurface(0.25, 0.3, 0.5, 1.0, 0.08);
  property->AddIsosurface(0.7, 1.0, 0.6, 0.2, 0.15);
  if (hasSilhouettes)
  {
    property->SetSilhouetteToExact();
  }
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetViewport(hasSilhouettes ? 0.5 : 0.0, 0.0, hasSilhouettes ? 1.0 : 0.5, 1.0);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(1.0, 4.0, 1.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(40.0);
  window->AddRenderer(renderer);
  renderer->ResetCameraClippingRange();
}
}

int TestProjectedBuckyball(int argc, char* argv[])
{
  vtkSmartPointer<vtkUnstructuredGrid> grid = buckyball::MakeGrid();
  if (grid->GetNumberOfCells() != 148955)
  {
    std::cout << "FAILED number of tetrahedra: " << grid->GetNumberOfCells() << std::endl;
    return EXIT_FAILURE;
  }
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  AddView(window, grid, false);
  AddView(window, grid, true);
  window->Render();
  // another rasteriser's rounding; without silhouettes the right half differs by 48
  return vtkRegressionTestImageThreshold(window, 5.0) == vtkRegressionTester::PASSED ? EXIT_SUCCESS
                                                                                     : EXIT_FAILURE;
}
