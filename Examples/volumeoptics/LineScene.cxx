// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineScene.h"

#include "vtkOpticsVolumeMapper.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMath.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int NumbersOfLight = 10;

void SetUpGrid(int grid, const double bounds[6], vtkAnisotropicLineVoxelizer* voxelizer)
{
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  const double edge = std::max(longest, 1e-30) / std::max(grid - 2, 1);
  int dimensions[3];
  double box[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = bounds[2 * axis + 1] - bounds[2 * axis];
    dimensions[axis] = std::min(static_cast<int>(std::ceil(size / edge - 1e-6)) + 2, grid);
    const double middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    box[2 * axis] = middle - 0.5 * edge * dimensions[axis];
    box[2 * axis + 1] = middle + 0.5 * edge * dimensions[axis];
  }
  voxelizer->SetSampleDimensions(dimensions);
  voxelizer->SetModelBounds(box);
}

vtkSmartPointer<vtkLight> MakeLight(const LineSettings& settings, const LightSettings& view)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(view.Intensity);
  if (vtkMath::Norm(settings.WorldLight) > 0.0)
  {
    light->SetLightTypeToSceneLight();
    light->SetPosition(settings.WorldLight);
    return light;
  }
  const double azimuth = vtkMath::RadiansFromDegrees(view.Azimuth);
  const double elevation = vtkMath::RadiansFromDegrees(view.Elevation);
  light->SetLightTypeToCameraLight();
  light->SetPosition(
    std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation));
  return light;
}

// A row of the voxels' field data LineLights: kind, direction to the light, diffuse and specular colour.
vtkSmartPointer<vtkLight> ReadLight(const double* numbers)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  const bool isInWorld = numbers[0] == 2.0, isFixedToEye = numbers[0] == 1.0;
  isInWorld        ? light->SetLightTypeToSceneLight()
    : isFixedToEye ? light->SetLightTypeToCameraLight()
                   : light->SetLightTypeToHeadlight();
  light->SetPosition(numbers + 1);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetDiffuseColor(numbers + 4);
  light->SetSpecularColor(numbers + 7);
  return light;
}
}

void SetUpVoxelizer(const LineSettings& settings, const LightSettings& light, const double bounds[6],
  vtkAnisotropicLineVoxelizer* voxelizer)
{
  SetUpGrid(settings.Grid, bounds, voxelizer);
  voxelizer->SetMaximumOrder(settings.Order);
  voxelizer->SetRadius(settings.Radius);
  voxelizer->SetCoefficientTolerance(settings.Tolerance);
  voxelizer->SetExactProduct(settings.ExactProduct);
  voxelizer->SetColorArray(settings.ColorArray.c_str());
  voxelizer->SetRadiusArray(settings.RadiusArray.c_str());
  vtkNew<vtkProperty> material;
  material->SetColor(settings.Color[0], settings.Color[1], settings.Color[2]);
  material->SetSpecularColor(1.0, 1.0, 1.0);
  material->SetAmbient(settings.Ambient);
  material->SetDiffuse(settings.Diffuse);
  material->SetSpecular(settings.Specular);
  voxelizer->SetMaterial(0, material);
  voxelizer->SetSpecularPower(0, settings.SpecularPower);
  vtkNew<vtkLightCollection> lights;
  lights->AddItem(MakeLight(settings, light));
  voxelizer->SetLights(lights);
}

// The camera follows from the bounds; then the evaluator can tell what it sees.
LineScene::LineScene(
  vtkImageData* voxels, const PictureSettings& picture, WindowKind kind, LineRenderer lineRenderer)
{
  vtkNew<vtkCamera> camera;
  this->Evaluator->SetInputData(voxels);
  this->Evaluator->SetCamera(camera);
  Volume volume;
  volume.Image = vtkSmartPointer<vtkImageData>::New();
  if (lineRenderer == LineRenderer::Mapper)
  {
    volume.Image->ShallowCopy(voxels);
  }
  else
  {
    this->Evaluator->Update();
    volume.Image->ShallowCopy(this->Evaluator->GetOutput());
  }
  this->Scene = std::make_unique<VolumeScene>(volume, kind);
  this->Scene->Apply(picture);
  if (picture.Step <= 0.0)
  {
    // half an edge of a cubic voxel
    this->Scene->GetMapper()->SetSampleDistance(
      static_cast<float>(0.75 * vtkAnisotropicVoxelEvaluator::GetScalarOpacityUnitDistance(voxels)));
  }
  if (lineRenderer == LineRenderer::Evaluator)
  {
    vtkRenderer* renderer = this->Scene->GetRenderer();
    this->Evaluator->SetCamera(renderer->GetActiveCamera());
    this->Scene->GetMapper()->SetInputConnection(this->Evaluator->GetOutputPort());
    this->Evaluator->SetUpVolume(vtkVolume::SafeDownCast(renderer->GetVolumes()->GetItemAsObject(0)));
  }
}

void LineScene::SetRadiusScale(int type, double scale)
{
  this->Evaluator->SetRadiusScale(type, scale);
  this->Scene->GetMapper()->SetLineRadiusScale(type, scale);
}

void LineScene::SetOpacityScale(int type, double scale)
{
  this->Evaluator->SetOpacityScale(type, scale);
  this->Scene->GetMapper()->SetLineOpacityScale(type, scale);
}

void LineScene::LightAs(vtkImageData* voxels)
{
  vtkRenderer* renderer = this->Scene->GetRenderer();
  renderer->RemoveAllLights();
  vtkDataArray* lights = voxels->GetFieldData()->GetArray("LineLights");
  const bool isComplete = lights && lights->GetNumberOfComponents() == NumbersOfLight;
  for (vtkIdType i = 0; isComplete && i < lights->GetNumberOfTuples(); ++i)
  {
    renderer->AddLight(ReadLight(lights->GetTuple(i)));
  }
  renderer->SetAutomaticLightCreation(0); // there may be ambient light alone
}

double LineScene::Render()
{
  return this->Scene->Render();
}
