// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightUniforms.h"

#include "VTKVersion.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTransform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using Vector = std::array<float, 3>;

Vector Scaled(const double* vector, double factor)
{
  return { static_cast<float>(vector[0] * factor), static_cast<float>(vector[1] * factor),
    static_cast<float>(vector[2] * factor) };
}

Vector DirectionInEye(vtkLight* light, vtkTransform* view)
{
  double direction[3];
  vtkMath::Subtract(light->GetTransformedFocalPoint(), light->GetTransformedPosition(), direction);
  const double* inEye = view->TransformVector(direction);
  const double length = vtkMath::Norm(inEye);
  return Scaled(inEye, length > 0.0 ? 1.0 / length : 0.0);
}

// A cone beyond 90 degrees is none, as in VTK.
Vector Cone(vtkLight* light)
{
  const double angle = light->GetConeAngle();
  const double cosine = angle <= 90.0 ? std::cos(vtkMath::RadiansFromDegrees(angle)) : -2.0;
  return { light->GetPositional() ? 1.0F : 0.0F, static_cast<float>(cosine),
    static_cast<float>(light->GetExponent()) };
}

void SetVectors(vtkShaderProgram* program, const char* name, const std::vector<Vector>& vectors)
{
  if (!vectors.empty() && program->IsUniformUsed(name))
  {
    program->SetUniform3fv(
      name, static_cast<int>(vectors.size()), reinterpret_cast<const float(*)[3]>(vectors.data()));
  }
}
}

//------------------------------------------------------------------------------
std::vector<vtkLight*> LightsThatAreOn(vtkRenderer* renderer)
{
  std::vector<vtkLight*> found;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      found.push_back(light);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
LightLimit::LightLimit(vtkRenderer* renderer)
{
  int count = 0;
  for (vtkLight* light : LightsThatAreOn(renderer))
  {
    if (++count > Largest && VTKLimitsLights)
    {
      light->SwitchOff();
      this->LeftOut.push_back(light);
    }
  }
}

//------------------------------------------------------------------------------
LightLimit::~LightLimit()
{
  for (vtkLight* light : this->LeftOut)
  {
    light->SwitchOn();
  }
}

//------------------------------------------------------------------------------
int CountLights(vtkRenderer* renderer)
{
  return static_cast<int>(LightsThatAreOn(renderer).size());
}

//------------------------------------------------------------------------------
std::vector<float> SharesOfLights(vtkRenderer* renderer)
{
  std::vector<double> intensities;
  double sum = 0.0;
  for (vtkLight* light : LightsThatAreOn(renderer))
  {
    const double* color = light->GetDiffuseColor();
    const double luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]; // of linear sRGB
    intensities.push_back(luminance * light->GetIntensity());
    sum += intensities.back();
  }
  std::vector<float> shares;
  shares.reserve(intensities.size());
  for (const double intensity : intensities)
  {
    shares.push_back(
      static_cast<float>(sum > 0.0 ? intensity / sum : 1.0 / static_cast<double>(intensities.size())));
  }
  return shares;
}

//------------------------------------------------------------------------------
bool HasPositionalLight(vtkRenderer* renderer)
{
  const std::vector<vtkLight*> lights = LightsThatAreOn(renderer);
  return std::any_of(
    lights.begin(), lights.end(), [](vtkLight* light) { return light->GetPositional() != 0; });
}

//------------------------------------------------------------------------------
void SetLightUniforms(vtkRenderer* renderer, vtkShaderProgram* program)
{
  vtkTransform* view = renderer->GetActiveCamera()->GetModelViewTransformObject();
  std::vector<Vector> diffuse, specular, direction, position, attenuation, cone;
  for (vtkLight* light : LightsThatAreOn(renderer))
  {
    diffuse.push_back(Scaled(light->GetDiffuseColor(), light->GetIntensity()));
    specular.push_back(Scaled(light->GetSpecularColor(), light->GetIntensity()));
    direction.push_back(DirectionInEye(light, view));
    position.push_back(Scaled(view->TransformPoint(light->GetTransformedPosition()), 1.0));
    attenuation.push_back(Scaled(light->GetAttenuationValues(), 1.0));
    cone.push_back(Cone(light));
  }
  SetVectors(program, "in_opticsLightDiffuse", diffuse);
  SetVectors(program, "in_opticsLightSpecular", specular);
  SetVectors(program, "in_opticsLightDirection", direction);
  SetVectors(program, "in_opticsLightPosition", position);
  SetVectors(program, "in_opticsLightAttenuation", attenuation);
  SetVectors(program, "in_opticsLightCone", cone);
}
