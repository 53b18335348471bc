// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A program that includes and links VTK alone: says which ray caster it gets, directly and inside
// vtkSmartVolumeMapper, and fails if it is not the one of the first argument; renders a frame with
// each and prints sums of its pixels if there is a second argument.

#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
class SmartMapper : public vtkSmartVolumeMapper
{
public:
  static SmartMapper* New();
  vtkTypeMacro(SmartMapper, vtkSmartVolumeMapper);
  std::string GetRayCaster() { return this->GPUMapper->GetClassName(); }
};
vtkStandardNewMacro(SmartMapper);

// A green egg, lit.
vtkSmartPointer<vtkVolume> MakeEgg(vtkVolumeMapper* mapper)
{
  const int size = 24;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < size * size * size; ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    const double radius = std::hypot(2.0 * (point[0] - 11.5), point[1] - 11.5, 2.0 * (point[2] - 11.5));
    value[i] = static_cast<float>(11.0 - radius);
  }
  mapper->SetInputDataObject(image);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 0.0, 0.5, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(3.0, 1.0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetSpecular(0.5);
  return volume;
}

// The sum of the picture's red, green and blue, after a look at its middle.
bool RendersEgg(vtkVolumeMapper* mapper)
{
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(MakeEgg(mapper));
  vtkNew<vtkRenderWindow> window;
  window->SetSize(100, 100);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, 99, 99, 0, pixels);
  long sum[3] = { 0, 0, 0 };
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
  {
    sum[i % 3] += pixels->GetValue(i);
  }
  std::cout << "picture: " << sum[0] << " " << sum[1] << " " << sum[2] << "\n";
  return pixels->GetValue(3 * (50 * 100 + 50) + 1) > 20;
}
}

int main(int argc, char* argv[])
{
  const std::string expected = argc > 1 ? argv[1] : "";
  auto direct = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  vtkNew<SmartMapper> smart;
  std::cout << "vtkGPUVolumeRayCastMapper: " << direct->GetClassName() << "\n"
            << "inside vtkSmartVolumeMapper: " << smart->GetRayCaster() << "\n";
  bool asExpected = direct->GetClassName() == expected && smart->GetRayCaster() == expected;
  if (argc > 2)
  {
    smart->SetRequestedRenderModeToGPU();
    asExpected = asExpected && RendersEgg(direct) && RendersEgg(smart);
  }
  return asExpected ? EXIT_SUCCESS : EXIT_FAILURE;
}
