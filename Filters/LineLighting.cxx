// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineLighting.h"

#include "Optics.h"

#include "vtkCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
const int TableSize = 4096; // intervals of [-pi/2, pi/2]

glm::dvec3 ToVector(const double numbers[3])
{
  return { numbers[0], numbers[1], numbers[2] };
}

glm::dvec3 UnitOr(const glm::dvec3& vector, const glm::dvec3& otherwise)
{
  const double length = glm::length(vector);
  return length > 0.0 && std::isfinite(length) ? vector / length : otherwise;
}

LineLight ReadLight(vtkLight* light)
{
  LineLight line;
  line.Diffuse = ToVector(light->GetDiffuseColor()) * light->GetIntensity();
  line.Specular = ToVector(light->GetSpecularColor()) * light->GetIntensity();
  if (light->LightTypeIsHeadlight())
  {
    return line;
  }
  double position[3], focalPoint[3];
  light->LightTypeIsCameraLight() ? light->GetPosition(position) : light->GetTransformedPosition(position);
  light->LightTypeIsCameraLight() ? light->GetFocalPoint(focalPoint)
                                  : light->GetTransformedFocalPoint(focalPoint);
  line.Kind = light->LightTypeIsCameraLight() ? LineLight::FixedToEye : LineLight::FixedInWorld;
  line.Direction = UnitOr(ToVector(position) - ToVector(focalPoint), glm::dvec3(0.0, 0.0, 1.0));
  const bool isAlongView = line.Kind == LineLight::FixedToEye && line.Direction.z > 1.0 - 1e-12;
  line.Kind = isAlongView ? LineLight::Headlight : line.Kind;
  return line;
}
}

std::vector<LineLight> ReadLights(vtkLightCollection* lights)
{
  if (!lights)
  {
    return { LineLight() };
  }
  std::vector<LineLight> all;
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      all.push_back(ReadLight(light));
    }
  }
  return all;
}

glm::dvec3 DirectionToLight(const LineLight& light, const glm::dvec3& toViewer, const glm::dvec3& viewUp)
{
  if (light.Kind == LineLight::FixedInWorld)
  {
    return light.Direction;
  }
  if (light.Kind == LineLight::Headlight)
  {
    return toViewer;
  }
  const glm::dvec3 other = std::abs(toViewer.x) < 0.8 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 right = UnitOr(glm::cross(viewUp, toViewer), glm::normalize(glm::cross(other, toViewer)));
  const glm::dvec3 up = glm::cross(toViewer, right);
  return light.Direction.x * right + light.Direction.y * up + light.Direction.z * toViewer;
}

LineMaterial ReadMaterial(vtkProperty* property, const glm::dvec3& ambientLight, bool hasColors)
{
  LineMaterial material;
  if (!property)
  {
    return material;
  }
  const glm::dvec3 white(1.0);
  material.Ambient =
    property->GetAmbient() * ambientLight * (hasColors ? white : ToVector(property->GetAmbientColor()));
  material.Diffuse = property->GetDiffuse() * (hasColors ? white : ToVector(property->GetDiffuseColor()));
  material.Specular = property->GetSpecular() * ToVector(property->GetSpecularColor());
  material.Exponent = std::clamp(property->GetSpecularPower(), 1.0, 1000.0);
  return material;
}

CosinePowerTable::CosinePowerTable(double exponent)
{
  this->Values.reserve(TableSize + 2);
  for (int i = 0; i <= TableSize; ++i)
  {
    const double angle = (static_cast<double>(i) / TableSize - 0.5) * 2.0 * optics::QuarterTurn;
    this->Values.push_back(optics::CosinePowerIntegral(exponent + 1.0, angle));
  }
  this->Values.push_back(this->Values.back());
}

double CosinePowerTable::At(double angle) const
{
  const double place =
    std::clamp((angle / optics::QuarterTurn * 0.5 + 0.5) * TableSize, 0.0, 1.0 * TableSize);
  const int i = static_cast<int>(place);
  return this->Values[i] + (place - i) * (this->Values[i + 1] - this->Values[i]);
}

CylinderRadiance RadianceOfCylinder(const glm::dvec3& tangent, const glm::dvec3& toViewer,
  const glm::dvec3& toLight, double exponent, const CosinePowerTable& table)
{
  const optics::CylinderView view = optics::ViewOfCylinder(tangent, toViewer);
  const optics::CylinderHighlight highlight = optics::HighlightOfCylinder(view, toLight, toViewer);
  const double integral = table.Integral(highlight.from, highlight.to);
  return { optics::DiffuseOfCylinder(view, toLight),
    optics::SpecularOfHighlight(highlight, exponent, integral) };
}
}
