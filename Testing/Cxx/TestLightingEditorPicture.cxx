// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The editor of lighting transfer functions as a picture: lines straight across are the three
// homogeneous regions, slanted ones the two boundaries, with a band on each; --histograms: upright axes,
// the 2D histograms beside, and lines between equal opacities.

#include "LightingEditorScene.h"

#include "vtkPiecewiseFunction.h"
#include "vtkRegressionTestImage.h"

#include <cstring>

int TestLightingEditorPicture(int argc, char* argv[])
{
  LightingEditorScene scene;
  const bool withHistograms = argc > 1 && std::strcmp(argv[1], "--histograms") == 0;
  vtkNew<vtkPiecewiseFunction> opacity; // 90 and 220 are equally opaque
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(60.0, 0.0);
  opacity->AddPoint(70.0, 0.5);
  opacity->AddPoint(256.0, 0.5);
  if (withHistograms)
  {
    scene.Item->ShowHistogramsOn();
    scene.Item->VerticalAxesOn();
    scene.Item->SetOpacityFunction(opacity);
  }
  else
  {
    scene.Item->InitializeFromHistogram(2);
    scene.Item->SetSelectedBoundary(0);
  }
  vtkRenderWindow* window = scene.View->GetRenderWindow();
  window->Render();
  return vtkRegressionTestImage(window) == vtkRegressionTester::FAILED ? EXIT_FAILURE : EXIT_SUCCESS;
}
