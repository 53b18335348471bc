// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The Marschner-Lobb signal in ambient light alone, with the cone of 60 degrees: crests light, troughs dark.

#include "vtkAnalyticVolumeSource.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

int TestOcclusionPicture(int argc, char* argv[])
{
  vtkNew<vtkAnalyticVolumeSource> field;
  field->SetDimensions(64, 64, 64);
  field->SetFieldToMarschnerLobb();
  vtkNew<vtkOpticsVolumeMapper> mapper;
  mapper->SetInputConnection(field->GetOutputPort());
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(0.01F);
  mapper->SetUseJittering(0);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.5, 0.95, 0.9, 0.8);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.45, 0.0);
  opacity->AddPoint(0.55, 0.9);
  vtkNew<vtkOpticsVolumeProperty> property;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(0.03);
  property->SetInterpolationTypeToLinear();
  property->OcclusionOn();

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.2, 0.3, 0.4);
  renderer->GetActiveCamera()->SetPosition(0.0, -2.0, 2.6);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.5);
  vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  window->Render();
  return !vtkRegressionTestImage(window);
}
