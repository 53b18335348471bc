// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders one frame of a ball without a display.

#include <vtkColorTransferFunction.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpticsVolumeMapper.h>
#include <vtkOpticsVolumeProperty.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
void FillWithBall(vtkImageData* image)
{
  const int size = 32;
  image->SetDimensions(size, size, size);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < size * size * size; ++i)
  {
    const float x = i % size - 15.5F;
    const float y = i / size % size - 15.5F;
    const float z = i / (size * size) - 15.5F;
    value[i] = 16.0F - std::sqrt(x * x + y * y + z * z);
  }
}
}

int main()
{
  vtkNew<vtkImageData> image;
  FillWithBall(image);
  vtkNew<vtkOpticsVolumeMapper> mapper;
  mapper->SetInputData(image);

  vtkNew<vtkOpticsVolumeProperty> optics;
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 1.0, 0.5, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(8.0, 1.0);
  optics->SetColor(colour);
  optics->SetScalarOpacity(opacity);
  optics->ShadeOn();

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(optics);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(100, 100);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(50, 50, 50, 50, 0, pixel, 0);
  const bool isOrange = pixel->GetValue(0) > pixel->GetValue(2) + 100;
  std::cout << "The pixel in the middle: " << +pixel->GetValue(0) << " " << +pixel->GetValue(1) << " "
            << +pixel->GetValue(2) << "\n";
  return isOrange ? EXIT_SUCCESS : EXIT_FAILURE;
}
