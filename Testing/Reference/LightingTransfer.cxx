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

// The scalars ahead and behind.
struct ScalarPair
{
  double ahead;
  double behind;
};

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

ScalarPair PairAt(const Scene& scene, const Sample& sample, const Vector& gradient)
{
  const double steepness = glm::length(gradient);
  const Vector direction = steepness > 0.0 ? gradient / steepness : Vector(0.0);
  const Vector offset = direction * (scene.gradientStepLength * scene.grid.SmallestSpacing());
  return { ValueWithin(scene, sample.position + offset), ValueWithin(scene, sample.position - offset) };
}

double OpacityOfStep(const Scene& scene, double opacity)
{
  return optics::OpacityForLength(opacity, scene.step / scene.unitDistance);
}

double WeightOf(vtkMultiSampleClassification* rules, int rule, const Vector& scalars)
{
  Vector low, high, softness;
  for (int i = 0; i < 3; ++i)
  {
    double range[2];
    rules->GetRange(rule, i, range);
    low[i] = range[0];
    high[i] = range[1];
    softness[i] = rules->GetSoftness(rule, i);
  }
  return optics::RuleWeight(scalars, low, high, softness);
}
}

//------------------------------------------------------------------------------
Vector PairGradientAt(const Scene& scene, const Sample& sample)
{
  if (scene.pairGradient == GradientEstimate::CentralDifferences)
  {
    return scene.field->Gradient(sample.position);
  }
  const Frame frame = scene.frames->At(sample.position);
  return frame.normal * -frame.magnitude;
}

//------------------------------------------------------------------------------
Classified ClassifiedAt(const Scene& scene, const Sample& sample)
{
  optics::ClassifiedSample classified;
  classified.opacity = OpacityOfStep(scene, scene.Opacity(sample.scalar));
  if (classified.opacity > 0.0 || scene.rules)
  {
    classified.color = scene.Color(sample.scalar);
  }
  if (scene.rules)
  {
    const ScalarPair pair = PairAt(scene, sample, PairGradientAt(scene, sample));
    for (int i = 0; i < scene.rules->GetNumberOfRules(); ++i)
    {
      double color[3];
      scene.rules->GetColor(i, color);
      optics::ClassifiedSample rule;
      rule.color = Vector(color[0], color[1], color[2]);
      rule.opacity = OpacityOfStep(scene, scene.rules->GetOpacity(i));
      const Vector scalars(sample.scalar, pair.ahead, pair.behind);
      classified = optics::ApplyRule(classified, rule, WeightOf(scene.rules, i, scalars));
    }
  }
  return { classified.color, classified.opacity };
}

//------------------------------------------------------------------------------
LightingCoefficients LightingCoefficientsAt(const Scene& scene, const Sample& sample, const Vector& gradient)
{
  const auto [ahead, behind] = PairAt(scene, sample, gradient);
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

namespace
{
LightingCoefficients CoefficientsAt(const Scene& scene, const Sample& sample, const Vector& gradient)
{
  return scene.lighting ? LightingCoefficientsAt(scene, sample, gradient)
                        : LightingCoefficients{ scene.ambient, scene.diffuse, scene.specular };
}
}

//------------------------------------------------------------------------------
double TransmissionAt(const Scene& scene, const Sample& sample)
{
  const LightingCoefficients coefficients = CoefficientsAt(scene, sample, PairGradientAt(scene, sample));
  const bool hasSide = scene.reflectance == Reflectance::VTK;
  return coefficients.diffuse * (hasSide ? std::abs(coefficients.side) : 1.0);
}

//------------------------------------------------------------------------------
Vector PhongRadiance(const Scene& scene, const Sample& sample, const Vector& color)
{
  const Vector gradient = PairGradientAt(scene, sample);
  const double steepness = glm::length(gradient);
  const LightingCoefficients coefficients = CoefficientsAt(scene, sample, gradient);
  const double side = coefficients.side < 0.0 ? -1.0 : 1.0;
  const Vector normal = steepness > 0.0 ? -side * gradient / steepness : Vector(0.0);
  Vector diffuse(0.0);
  Vector specular(0.0);
  for (const Light& light : scene.lights)
  {
    Illumination illumination = IlluminationAt(scene, light, sample.position);
    illumination.factor *= 1.0 - ShareBehind(scene, sample, illumination.toLight);
    const Vector between = illumination.toLight + sample.toViewer;
    const double cosHalf = glm::dot(normal, between) / std::max(glm::length(between), 1.0e-10);
    diffuse +=
      illumination.factor * Facing(glm::dot(normal, illumination.toLight), scene.twoSided) * light.diffuse;
    const double facing = Facing(cosHalf, scene.twoSided);
    if (facing > 0.0)
    {
      specular += illumination.factor * std::pow(facing, scene.specularPower) * light.specular;
    }
  }
  const double fade = std::abs(coefficients.side);
  const Vector radiance =
    color * (coefficients.ambient * AmbientLight(scene, sample) + coefficients.diffuse * fade * diffuse) +
    coefficients.specular * fade * specular;
  return glm::min(radiance, LargestRadiance);
}
}
