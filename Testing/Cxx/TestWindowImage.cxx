// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// One picture of a surface inside a volume, with the window that vtkRenderWindow::New() gives: X and
// headless windows share the baseline. The pattern of an image test.

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkConeSource.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <cmath>

namespace
{
void FillWithBall(vtkImageData* image)
{
  const int size = 32;
  image->SetDimensions(size, size, size);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(-1.55, -1.55, -1.55);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < size * size * size; ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    value[i] = static_cast<float>(1.6 - std::hypot(point[0], point[1], point[2]));
  }
}
}

int TestWindowImage(int argc, char* argv[])
{
  vtkNew<vtkImageData> image;
  FillWithBall(image);
  vtkNew<vtkOpticsVolumeMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkOpticsVolumeProperty> optics;
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 0.2, 0.4, 1.0);
  colour->AddRGBPoint(1.6, 1.0, 0.9, 0.3);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.2, 0.0);
  opacity->AddPoint(1.6, 0.3);
  optics->SetColor(colour);
  optics->SetScalarOpacity(opacity);
  optics->SetInterpolationTypeToLinear();
  optics->ShadeOn();
  optics->SetScalarOpacityUnitDistance(0.2);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(optics);

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(32);
  cone->SetHeight(2.0);
  cone->SetRadius(0.8);
  cone->SetDirection(1.0, 1.0, 1.0);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(surface);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(200, 200);
  window->AddRenderer(renderer);
  renderer->SetBackground(0.3, 0.3, 0.3);
  window->Render();
  return vtkRegressionTestImage(window) == vtkRegressionTester::FAILED ? EXIT_FAILURE : EXIT_SUCCESS;
}
