// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A ball above a floor, in [-1, 1]^3: what of the floor is dark is the shadow of the ball. Nothing but
// direct light, and nothing of the surfaces' normals, is seen.

#ifndef ShadowScene_h
#define ShadowScene_h

#include "TestScene.h"

#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkPointData.h"

#include <cmath>

namespace
{
struct ShadowScene : TestScene
{
  static constexpr int Points = 41;

  ShadowScene()
  {
    this->Mapper->SetInputData(Image());
    this->Mapper->SetSampleDistance(0.025F);
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.0, 0.0);
    this->Opacity->AddPoint(1.0, 0.6);
    this->Property->SetReflectanceModelToNone();
    this->Property->SetAmbient(0.0);
    this->Property->SetDiffuse(1.0);
    this->Property->ShadowsOn();
    this->Optics->SetVisibilityGridSize(96);
    this->Window->SetSize(60, 60);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Renderer->SetAutomaticLightCreation(false);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.5, -3.5, 2.5);
    camera->SetViewAngle(35.0);
    this->Renderer->ResetCameraClippingRange(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  }

  static vtkSmartPointer<vtkImageData> Image()
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(Points, Points, Points);
    image->SetOrigin(-1.0, -1.0, -1.0);
    const double spacing = 2.0 / (Points - 1);
    image->SetSpacing(spacing, spacing, spacing);
    vtkNew<vtkFloatArray> values;
    values->SetNumberOfTuples(image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double* p = image->GetPoint(i);
      const double ball = 0.35 - std::sqrt(p[0] * p[0] + p[1] * p[1] + (p[2] - 0.2) * (p[2] - 0.2));
      const double inside = std::max(ball, -0.6 - p[2]);
      values->SetValue(i, static_cast<float>(std::clamp(0.5 + inside / 0.1, 0.0, 1.0)));
    }
    image->GetPointData()->SetScalars(values);
    return image;
  }

  vtkLight* AddLight(double x, double y, double z, bool positional)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPositional(positional);
    light->SetConeAngle(180.0);
    this->Renderer->AddLight(light);
    return light;
  }
  vtkLight* AddSun(double x, double y, double z) { return this->AddLight(x, y, z, false); }
  vtkLight* AddLamp(double x, double y, double z) { return this->AddLight(x, y, z, true); }
};
}

#endif
