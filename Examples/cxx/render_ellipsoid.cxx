// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// An ellipsoid whose highlights run along it, drawn without a display into ellipsoid.png.

#include <vtkAnalyticVolumeSource.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpticsVolumeMapper.h>
#include <vtkOpticsVolumeProperty.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkWindowToImageFilter.h>

int main()
{
  vtkNew<vtkAnalyticVolumeSource> source; // any vtkImageData in its place
  source->SetFieldToEllipsoid();
  vtkNew<vtkOpticsVolumeMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->SetQualityToBalanced();

  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.45, 0.0);
  opacity->AddPoint(0.55, 0.9);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.5, 0.45, 0.6, 0.72);

  vtkNew<vtkOpticsVolumeProperty> property;
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(0.05);
  property->SetColor(color);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetReflectanceModelToWard();
  property->SetFrameSourceToCurvature(); // Covariance, the default, is for structures
  property->SetAnisotropyScale(1.0);
  property->SetGlossiness(0.2);
  property->SetSpecular(0.6);

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->GetActiveCamera()->SetPosition(1.0, -3.0, 0.8);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkHeadlessRenderWindow> window;
  window->AddRenderer(renderer);
  window->SetSize(400, 400);

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName("ellipsoid.png");
  writer->Write();
}
