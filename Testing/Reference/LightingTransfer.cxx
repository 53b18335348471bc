// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingTransfer.h"

#include "Optics.h"

#include "vtkLightingTransferFunction.h"

#include <algorithm>
#include <cmath>

namespace reference
{
namespace
{
// The mapper clamps its half floats there.
const double LargestRadiance = 65504.0;

double Facing(double cosine, bool twoSided)
{
  return twoSided ? std::abs(cosine) : std::max(cosine, 0.0);
}

// S1 and S2: of the field outside of the grid its border's, as the mapper's texture has it.
double ValueWithin(const Scene& scene, const Vector& point)
{
  const Grid& grid = scene.grid;
  const Vector index = grid.ToIndex(point);
  Vector inside = grid.corner;
  for (int axis = 0; axis < 3; ++axis)
  {
    inside += grid.Step(axis) * std::clamp(index[axis], 0.0, grid.points[axis] - 1.0);
  }
  return scene.field->Value(inside);
}
}

//------------------------------------------------------------------------------
LightingCoefficients LightingCoefficientsAt(const Scene& scene, const Sample& sample, const Vector& gradient)
{
  const double steepness = glm::length(gradient);
  const Vector direction = steepness > 0.0 ? gradient / steepness : Vector(0.0);
  const Vector offset = direction * (scene.gradientStepLength * scene.grid.SmallestSpacing());
  const double ahead = ValueWithin(scene, sample.position + offset);
  const double behind = ValueWithin(scene, sample.position - offset);
  double values[3];
  scene.lighting->Evaluate(ahead, behind, values);
  LightingCoefficients coefficients;
  coefficients.ambient = values[0] * scene.lightScale;
  coefficients.diffuse = values[1] * scene.lightScale;
  coefficients.specular = values[2] * scene.lightScale;
  if (scene.hybridNormals)
  {
    coefficients.side = optics::HybridSide(scene.Opacity(ahead) - scene.Opacity(behind), scene.densityFade);
  }
  return coefficients;
}

//------------------------------------------------------------------------------
Vector LightingTransferRadiance(const Scene& scene, const Sample& sample, const Vector& color)
{
  const Vector gradient = scene.field->Gradient(sample.position);
  const double steepness = glm::length(gradient);
  const LightingCoefficients coefficients = LightingCoefficientsAt(scene, sample, gradient);
  const double side = coefficients.side < 0.0 ? -1.0 : 1.0;
  const Vector normal = steepness > 0.0 ? -side * gradient / steepness : Vector(0.0);
  const bool twoSided = scene.twoSided && !scene.hybridNormals;
  Vector diffuse(0.0);
  Vector specular(0.0);
  for (const Light& light : scene.lights)
  {
    const Illumination illumination = IlluminationAt(scene, light, sample.position);
    const Vector between = illumination.toLight + sample.toViewer;
    const double cosHalf = glm::dot(normal, between) / std::max(glm::length(between), 1.0e-10);
    diffuse += illumination.factor * Facing(glm::dot(normal, illumination.toLight), twoSided) * light.diffuse;
    const double facing = Facing(cosHalf, twoSided);
    if (facing > 0.0)
    {
      specular += illumination.factor * std::pow(facing, scene.specularPower) * light.specular;
    }
  }
  const double fade = std::abs(coefficients.side);
  const Vector radiance = color * (coefficients.ambient + coefficients.diffuse * fade * diffuse) +
    coefficients.specular * fade * specular;
  return glm::min(radiance, LargestRadiance);
}
}
