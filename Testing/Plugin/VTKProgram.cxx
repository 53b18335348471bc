// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A program that includes and links VTK alone: says which ray caster it gets, directly and inside
// vtkSmartVolumeMapper, and fails if it is not the one of the first argument; renders a frame with
// it if there is a second argument.

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

#include <algorithm>
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

vtkSmartPointer<vtkVolume> MakeBlock(vtkVolumeMapper* mapper)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 16);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(voxels, voxels + image->GetNumberOfPoints(), 200);
  mapper->SetInputDataObject(image);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 1.0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colour);
  volume->GetProperty()->SetScalarOpacity(opacity);
  return volume;
}

bool RendersGreen(vtkVolumeMapper* mapper)
{
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(MakeBlock(mapper));
  vtkNew<vtkRenderWindow> window;
  window->SetSize(100, 100);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(50, 50, 50, 50, 0, pixel);
  return pixel->GetValue(1) > 100 && pixel->GetValue(0) == 0;
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
    asExpected = asExpected && RendersGreen(direct) && RendersGreen(smart);
  }
  return asExpected ? EXIT_SUCCESS : EXIT_FAILURE;
}
