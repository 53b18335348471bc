// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A small scene for tests of the mapper: an ellipsoid, 150 x 150 pixels, jitter off, fixed step. Empty space is not
// skipped, so that terms can be counted; TestEmptySpace switches it on, and compares.

#ifndef TestScene_h
#define TestScene_h

#include "Check.h"
#include "FloatTarget.h"
#include "WindowPixels.h"
#include "vtkAnalyticVolumeSource.h"
#include "vtkLightingTransferFunction.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{
struct TestScene
{
  // mapper: ours where null
  explicit TestScene(vtkGPUVolumeRayCastMapper* mapper = nullptr)
    : Mapper(mapper ? mapper : static_cast<vtkGPUVolumeRayCastMapper*>(this->Optics))
    , Window(vtkSmartPointer<vtkRenderWindow>::New())
  {
    this->Source->SetDimensions(32, 32, 32);
    this->Source->SetFieldToEllipsoid();
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Mapper->SetAutoAdjustSampleDistances(0);
    this->Mapper->SetSampleDistance(0.02F);
    this->Mapper->SetUseJittering(0);
    this->Optics->SkipEmptySpaceOff();

    this->Opacity->AddPoint(0.4, 0.0);
    this->Opacity->AddPoint(0.6, 0.9);
    this->Color->AddRGBPoint(0.0, 0.2, 0.3, 0.8);
    this->Color->AddRGBPoint(1.0, 0.9, 0.7, 0.5);
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetScalarOpacityUnitDistance(0.05);
    this->Property->SetColor(this->Color);
    this->Property->SetInterpolationTypeToLinear();
    this->Property->ShadeOn();

    this->Volume->SetMapper(this->Mapper);
    this->Volume->SetProperty(this->Property);
    this->Renderer->AddVolume(this->Volume);
    this->Renderer->SetBackground(0.1, 0.2, 0.3);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(150, 150);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->SetPosition(1.0, -2.5, 1.2);
    this->Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
  }

  std::vector<unsigned char> Render() { return RenderPixels(this->Window); }

  std::vector<float> RenderFloat() { return ::RenderFloat(this->Window, this->Renderer); }

  vtkNew<vtkAnalyticVolumeSource> Source;
  vtkNew<vtkOpticsVolumeMapper> Optics;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkOpticsVolumeProperty> Property;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
};

// Warnings of an object, which would fail the test as output.
struct Warnings
{
  explicit Warnings(vtkObject* object)
  {
    this->Command->SetClientData(&this->Texts);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* client, void* text) {
      static_cast<std::vector<std::string>*>(client)->push_back(static_cast<const char*>(text));
    });
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  vtkNew<vtkCallbackCommand> Command;
  std::vector<std::string> Texts;
};

// A lighting transfer function that lights every pair of scalars alike.
inline void LightEverywhere(TestScene& scene, double ambient, double diffuse, double specular)
{
  vtkNew<vtkLightingTransferFunction> function;
  const double all[2] = { -1.0e300, 1.0e300 };
  function->AddBoundary(all, all, ambient, diffuse, specular);
  scene.Property->SetLightingTransferFunction(function);
}

inline int LargestDifference(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  int largest = a.size() == b.size() ? 0 : 256;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(int(a[i]) - int(b[i])));
  }
  return largest;
}

inline bool AreFinite(const std::vector<float>& pixels)
{
  return std::all_of(pixels.begin(), pixels.end(), [](float value) { return std::isfinite(value); });
}
}

#endif
