// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scene.h"

#include "vtkCamera.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <stdexcept>

namespace reference
{
namespace
{
glm::dmat4 FromVTK(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

Vector TransformPoint(const glm::dmat4& matrix, const double* point)
{
  const glm::dvec4 p = matrix * glm::dvec4(point[0], point[1], point[2], 1.0);
  return Vector(p) / p.w;
}

Camera CameraOf(vtkRenderer* renderer, const glm::dmat4& worldToDataset, int width, int height)
{
  vtkCamera* source = renderer->GetActiveCamera();
  const double aspect = static_cast<double>(width) / height;
  const glm::dmat4 worldToDevice = FromVTK(source->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0));
  Camera camera;
  camera.deviceToDataset = worldToDataset * glm::inverse(worldToDevice);
  camera.eye = TransformPoint(worldToDataset, source->GetPosition());
  const double* range = source->GetClippingRange();
  camera.nearOffset = std::max(0.001 * (range[1] - range[0]), 1000.0 * FLT_EPSILON); // as VTK
  camera.width = width;
  camera.height = height;
  return camera;
}

Light LightOf(vtkLight* source, const glm::dmat4& worldToDataset)
{
  const double intensity = source->GetIntensity();
  auto scaled = [intensity](const double* color) { return intensity * Vector(color[0], color[1], color[2]); };
  Light light;
  light.positional = source->GetPositional() != 0;
  light.headlight = source->LightTypeIsHeadlight() != 0;
  light.shadowAttenuation = source->GetShadowAttenuation();
  light.ambient = scaled(source->GetAmbientColor());
  light.diffuse = scaled(source->GetDiffuseColor());
  light.specular = scaled(source->GetSpecularColor());
  double position[3];
  double focalPoint[3];
  source->GetTransformedPosition(position);
  source->GetTransformedFocalPoint(focalPoint);
  light.position = TransformPoint(worldToDataset, position);
  const Vector travel = glm::normalize(TransformPoint(worldToDataset, focalPoint) - light.position);
  light.toLight = -travel;
  light.coneAxis = travel;
  light.coneAngle = source->GetConeAngle();
  light.exponent = source->GetExponent();
  const double* attenuation = source->GetAttenuationValues();
  light.attenuation = Vector(attenuation[0], attenuation[1], attenuation[2]);
  return light;
}

// A sixteenth of the difference between the most and the least opaque scalars, as the mapper takes it.
double DensityFade(vtkPiecewiseFunction* opacity, vtkImageData* image)
{
  double range[2];
  image->GetScalarRange(range);
  double densities[256];
  opacity->GetTable(range[0], range[1], 256, densities);
  const auto [least, largest] = std::minmax_element(densities, densities + 256);
  return (*largest - *least) / 16.0;
}

void CopyDataSpace(vtkOpticsVolumeProperty* optics, Scene& scene)
{
  scene.integrationSpace = static_cast<IntegrationSpace>(optics->GetIntegrationSpace());
  scene.classification = static_cast<Classification>(optics->GetClassification());
  scene.unitInterval = optics->GetScalarOpacityUnitInterval();
  scene.silhouette = static_cast<Silhouette>(optics->GetSilhouette());
  scene.transmittedLight = static_cast<TransmittedLight>(optics->GetTransmittedLight());
  for (int i = 0; i < optics->GetNumberOfIsosurfaces(); ++i)
  {
    Isosurface surface;
    surface.value = optics->GetIsosurfaceValue(i);
    surface.opacity = optics->GetIsosurfaceOpacity(i);
    surface.color = scene.Color(surface.value);
    if (optics->GetIsosurfaceHasColor(i))
    {
      double rgb[3];
      optics->GetIsosurfaceColor(i, rgb);
      surface.color = Vector(rgb[0], rgb[1], rgb[2]);
    }
    scene.isosurfaces.push_back(surface);
  }
}

void CopyProperty(vtkVolumeProperty* property, Scene& scene)
{
  scene.opacity = property->GetScalarOpacity();
  scene.color = vtkSmartPointer<vtkColorTransferFunction>::New();
  if (property->GetColorChannels() == 3)
  {
    scene.color = property->GetRGBTransferFunction();
  }
  else
  {
    vtkPiecewiseFunction* gray = property->GetGrayTransferFunction();
    for (int i = 0; i < gray->GetSize(); ++i)
    {
      double node[4];
      gray->GetNodeValue(i, node);
      scene.color->AddRGBPoint(node[0], node[1], node[1], node[1], node[2], node[3]);
    }
  }
  scene.unitDistance = property->GetScalarOpacityUnitDistance();
  scene.shade = property->GetShade() != 0;
  scene.ambient = property->GetAmbient();
  scene.diffuse = property->GetDiffuse();
  scene.specular = property->GetSpecular();
  scene.specularPower = property->GetSpecularPower();
  if (auto* optics = vtkOpticsVolumeProperty::SafeDownCast(property))
  {
    scene.reflectance = static_cast<Reflectance>(optics->GetReflectanceModel());
    scene.glossiness = optics->GetGlossiness();
    scene.anisotropyScale = optics->GetAnisotropyScale();
    scene.scatteringAnisotropy = optics->GetScatteringAnisotropy();
    scene.specularFromExtinction = optics->GetSpecularFromExtinction();
    CopyDataSpace(optics, scene);
    scene.lighting = optics->GetLightingTransferFunction();
    scene.rules = optics->GetMultiSampleClassification();
    scene.gradientStepLength = optics->GetGradientStepLength();
    scene.lightScale = optics->GetLightScale();
    scene.hybridNormals = optics->GetHybridNormals();
    const double* ambient = optics->GetAmbientColor();
    scene.ambientColor = Vector(ambient[0], ambient[1], ambient[2]);
  }
}
}

//------------------------------------------------------------------------------
Vector Scene::Color(double scalar) const
{
  double rgb[3];
  this->color->GetColor(scalar, rgb);
  return Vector(rgb[0], rgb[1], rgb[2]);
}

//------------------------------------------------------------------------------
double Scene::RangeOfOpacity() const
{
  const double* range = this->opacity->GetRange();
  return range[1] > range[0] ? range[1] - range[0] : 1.0;
}

//------------------------------------------------------------------------------
double Scene::EffectiveUnitInterval() const
{
  return this->unitInterval > 0.0 ? this->unitInterval : this->RangeOfOpacity() / 100.0;
}

//------------------------------------------------------------------------------
Scene SceneFromVTK(vtkRenderer* renderer, vtkVolume* volume, int width, int height)
{
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  auto* image = mapper ? vtkImageData::SafeDownCast(mapper->GetDataSetInput()) : nullptr;
  if (!image)
  {
    throw std::invalid_argument("The reference draws an image through a GPU volume mapper.");
  }
  const glm::dmat4 datasetToWorld = FromVTK(volume->GetMatrix());
  const glm::dmat4 worldToDataset = glm::inverse(datasetToWorld);
  auto field = std::make_shared<GridField>(image);
  Scene scene;
  scene.grid = field->GetGrid();
  scene.field = field;
  scene.worldScale = std::cbrt(std::abs(glm::determinant(glm::dmat3(datasetToWorld))));
  scene.camera = CameraOf(renderer, worldToDataset, width, height);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      scene.lights.push_back(LightOf(light, worldToDataset));
    }
  }
  CopyProperty(volume->GetProperty(), scene);
  scene.twoSided = renderer->GetTwoSidedLighting() != 0 && !(scene.lighting && scene.hybridNormals);
  scene.densityFade = DensityFade(scene.opacity, image);
  scene.step = mapper->GetSampleDistance();
  return scene;
}
}
