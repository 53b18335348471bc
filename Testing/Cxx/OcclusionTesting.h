// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A white floor under something that hides light from it, for tests of occlusion: seen from +z, in
// [-2, 2]^2 x [-0.5, 0.5]. What the scalars mean: 0 nothing, 0.25 black glass, 1 white and dense.

#ifndef OcclusionTesting_h
#define OcclusionTesting_h

#include "TestScene.h"
#include "vtkVisibilitySweep.h"

#include "vtkMath.h"

#include <functional>

namespace
{
using Density = std::function<double(double x, double y, double z)>;

const double FloorHeight = -0.4; // where the floor is half as dense as inside
const double Glass = 0.25;
const double Dense = 1.0;

inline double Floor(double, double, double z)
{
  return z < FloorHeight ? Dense : 0.0;
}

// 65 x 65 x 33 points, voxels of 1/16 x 1/16 x 1/32.
inline vtkSmartPointer<vtkImageData> MakeImage(const Density& density)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(65, 65, 33);
  image->SetOrigin(-2.0, -2.0, -0.5);
  image->SetSpacing(1.0 / 16.0, 1.0 / 16.0, 1.0 / 32.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* point = image->GetPoint(i);
    static_cast<float*>(image->GetScalarPointer())[i] =
      static_cast<float>(density(point[0], point[1], point[2]));
  }
  return image;
}

struct OcclusionScene : public TestScene
{
  explicit OcclusionScene(const Density& density, double glassOpacity = 0.0, int size = 33)
  {
    this->Mapper->SetInputDataObject(MakeImage(density));
    this->Mapper->SetSampleDistance(1.0F / 128.0F);
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.0, 0.0);
    this->Opacity->AddPoint(0.1, 0.0);
    this->Opacity->AddPoint(0.2, glassOpacity);
    this->Opacity->AddPoint(0.3, glassOpacity);
    this->Opacity->AddPoint(0.4, 0.0);
    this->Opacity->AddPoint(0.5, 0.0);
    this->Opacity->AddPoint(0.9, 0.99);
    this->Color->RemoveAllPoints();
    this->Color->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
    this->Color->AddRGBPoint(0.45, 0.0, 0.0, 0.0);
    this->Color->AddRGBPoint(0.46, 1.0, 1.0, 1.0);
    this->Color->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
    this->Property->SetScalarOpacityUnitDistance(0.02);
    this->Property->ShadeOff();
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Window->SetSize(size, size);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    this->Renderer->ResetCameraClippingRange();
  }

  // Red of the pixel nearest to the middle, or another one's.
  double Red(int dx = 0, int dy = 0)
  {
    const std::vector<float> pixels = this->RenderFloat();
    const int* size = this->Window->GetSize();
    const int pixel = (size[1] / 2 + dy) * size[0] + size[0] / 2 + dx;
    return pixels[pixels.size() / (std::size_t(1) * size[0] * size[1]) * pixel];
  }

  // What occlusion leaves of the pixel.
  double Visibility(int dx = 0, int dy = 0)
  {
    this->Property->OcclusionOff();
    const double all = this->Red(dx, dy);
    this->Property->OcclusionOn();
    return this->Red(dx, dy) / all;
  }
};

// The mean over the cosines of a cone.
inline double MeanOverCone(double degrees, const std::function<double(double cosine)>& function)
{
  const double least = std::cos(vtkMath::RadiansFromDegrees(degrees));
  const int parts = 4000;
  double sum = 0.0;
  for (int i = 0; i < parts; ++i)
  {
    sum += function(least + (1.0 - least) * (i + 0.5) / parts) / parts;
  }
  return sum;
}

// What the points of a dense floor with nothing above it see past each other: of an extinction s,
// int exp(-s z) s exp(-s z / c) dz = c / (c + 1).
inline double OpenFloor(double degrees)
{
  return MeanOverCone(degrees, [](double cosine) { return cosine / (cosine + 1.0); });
}
}

#endif
