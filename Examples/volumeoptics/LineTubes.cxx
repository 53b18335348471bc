// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineTubes.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>

#include <cmath>

namespace
{
const int Supersampling = 10;

// VTK's lobe is Phong's: a fourth of Blinn's exponent is as wide.
void ApplyMaterial(const LineSettings& settings, vtkProperty* property)
{
  property->SetColor(settings.Color[0], settings.Color[1], settings.Color[2]);
  property->SetSpecularColor(1.0, 1.0, 1.0);
  property->SetAmbient(settings.Ambient);
  property->SetDiffuse(settings.Diffuse);
  property->SetSpecular(settings.Specular);
  property->SetSpecularPower(settings.SpecularPower / 4.0);
}
}

// The mean width of a prism is its perimeter over pi.
vtkSmartPointer<vtkPolyData> MakeTubes(vtkPolyData* lines, double radius, int sides)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(radius * (vtkMath::Pi() / sides) / std::sin(vtkMath::Pi() / sides));
  tubes->SetNumberOfSides(sides);
  tubes->Update();
  return tubes->GetOutput();
}

TubeFrame DrawTubes(vtkPolyData* lines, const LineSettings& settings, VolumeScene& scene, int sides)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeTubes(lines, settings.Radius, sides));
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  ApplyMaterial(settings, actor->GetProperty());
  scene.GetRenderer()->RemoveAllViewProps();
  scene.GetRenderer()->AddActor(actor);
  const int* size = scene.GetWindow()->GetSize();
  scene.GetWindow()->SetSize(size[0] * Supersampling, size[1] * Supersampling);
  TubeFrame result;
  result.Seconds = scene.Render();
  result.Frame = Reduced(ToFramePicture(scene.Capture()), Supersampling);
  scene.GetRenderer()->RemoveActor(actor);
  return result;
}
