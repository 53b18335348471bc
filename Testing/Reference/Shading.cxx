// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shading.h"

#include "LightingTransfer.h"
#include "Optics.h"

#include <algorithm>
#include <cmath>

namespace reference
{
namespace
{
// The paper's exponent of specular reflection is VTK's specular power.
Vector Transmitted(const Scene& scene, const Sample& sample)
{
  Vector sum(0.0);
  const Vector gradient = PairGradientAt(scene, sample);
  const double length = glm::length(gradient);
  if (scene.transmittedLight == TransmittedLight::Off || !(length > 0.0))
  {
    return sum;
  }
  for (const Light& light : scene.lights)
  {
    const Illumination illumination = IlluminationAt(scene, light, sample.position);
    const glm::dvec2 through =
      optics::TransmittedLight(gradient / length, illumination.toLight, sample.toViewer, scene.specularPower);
    const double specular = scene.transmittedLight == TransmittedLight::DiffuseAndSpecular ? through.y : 0.0;
    const double behind = ShareBehind(scene, sample, illumination.toLight);
    sum += behind * illumination.factor * (through.x + specular) * light.diffuse;
  }
  return sum;
}

double DepthOf(const Scene& scene, double scalar)
{
  return optics::BoundedOpticalDepth(scene.Opacity(scalar));
}

// A negative cosine counts as its absolute value if light falls on both sides.
double Facing(double cosine, bool twoSided)
{
  return twoSided ? std::abs(cosine) : std::max(cosine, 0.0);
}

// VTK's shading by one headlight takes the direction to the eye, from where the ray enters the volume,
// for light and half vector alike, and the gradient's own direction for the normal: one-sided, it lights
// the far sides (and raises negative cosines to a power, which is undefined).
Vector HeadlightPhong(const Scene& scene, const Sample& sample, const Vector& color)
{
  const Light& light = scene.lights.front();
  const Vector gradient = scene.field->Gradient(sample.position);
  const double length = glm::length(gradient);
  const Vector toEye = glm::normalize(scene.camera.eye - sample.entry);
  const double cosine = length > 0.0 ? Facing(glm::dot(gradient / length, toEye), scene.twoSided) : 0.0;
  const Vector direct = scene.diffuse * cosine * light.diffuse * color +
    scene.specular * std::pow(cosine, scene.specularPower) * light.specular;
  return scene.ambient * AmbientLight(scene, sample) * color +
    ShareOfLight(scene, light, sample.position) * direct;
}

// VTK's shading by other lights: the ambient term is the lights' alone. VTK 9.1 takes a wrong direction
// to the viewer for directional lights' half vector, the last light's highlight alone, and the wrong
// sign for positional lights' half vector; here the highlights are where they belong.
Vector VTKPhong(const Scene& scene, const Sample& sample, const Vector& color)
{
  const Vector gradient = scene.field->Gradient(sample.position);
  const double length = glm::length(gradient);
  const Vector normal = length > 0.0 ? -gradient / length : Vector(0.0);
  Vector ambient(0.0);
  Vector diffuse(0.0);
  Vector specular(0.0);
  for (const Light& light : scene.lights)
  {
    const Illumination illumination = IlluminationAt(scene, light, sample.position);
    const Vector between = illumination.toLight + sample.toViewer;
    const double cosHalf = glm::dot(normal, between) / std::max(glm::length(between), 1.0e-6);
    ambient += light.ambient;
    diffuse +=
      illumination.factor * Facing(glm::dot(normal, illumination.toLight), scene.twoSided) * light.diffuse;
    const double facing = Facing(cosHalf, scene.twoSided);
    if (facing > 0.0)
    {
      specular += illumination.factor * std::pow(facing, scene.specularPower) * light.specular;
    }
  }
  return scene.ambient * AmbientLight(scene, sample) * ambient + scene.diffuse * diffuse * color +
    scene.specular * specular;
}

// The frame is that of the unclassified scalar; central differences give the extinction's normal
// another direction, so its tangents are made orthogonal to that again.
optics::AnisotropyFrame FrameAround(const Vector& normal, const Frame& stored)
{
  optics::AnisotropyFrame frame = optics::EigenFrame(stored.normal, stored.anisotropy);
  const Vector major = frame.major - normal * glm::dot(normal, frame.major);
  frame.major = major / std::max(glm::length(major), 1.0e-10);
  frame.minor = glm::cross(normal, frame.major);
  return frame;
}

// f_s max(N.L, 0) of the chosen model.
double ReflectedBy(const Scene& scene, const ExtinctionGradient& extinction, Vector normal,
  const Vector& toLight, const Vector& toViewer)
{
  if (scene.twoSided && glm::dot(normal, toLight) < 0.0)
  {
    normal = -normal;
  }
  if (scene.reflectance == Reflectance::BlinnPhong)
  {
    return optics::BlinnPhongReflection(normal, toLight, toViewer, scene.glossiness);
  }
  const optics::AnisotropyFrame frame = FrameAround(normal, extinction.frame);
  if (scene.reflectance == Reflectance::Ward)
  {
    const double major = optics::WardMajorRoughness(scene.glossiness, frame.logRatio, scene.anisotropyScale);
    return optics::WardReflection(
      normal, frame.major, frame.minor, toLight, toViewer, major, scene.glossiness);
  }
  const double weight = optics::LafortuneMajorWeight(frame.logRatio, scene.anisotropyScale);
  return optics::LafortuneReflection(
    normal, frame.major, frame.minor, toLight, toViewer, weight, scene.glossiness);
}

ExtinctionGradient FromStoredNormal(const Scene& scene, const Sample& sample)
{
  ExtinctionGradient result;
  result.frame = scene.frames->At(sample.position);
  const double h = scene.grid.SmallestSpacing();
  const double change = result.frame.magnitude * h;
  const double ahead = DepthOf(scene, sample.scalar + change);
  const double behind = DepthOf(scene, sample.scalar - change);
  result.normal = ahead >= behind ? result.frame.normal : -result.frame.normal;
  result.coefficient = optics::SpecularCoefficient(ahead, behind, scene.unitDistance / h);
  return result;
}

ExtinctionGradient FromCentralDifferences(const Scene& scene, const Sample& sample)
{
  ExtinctionGradient result;
  result.frame = scene.frames->At(sample.position);
  Vector gradient(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector step = scene.grid.Step(axis);
    const double ahead = DepthOf(scene, scene.field->Value(sample.position + step));
    const double behind = DepthOf(scene, scene.field->Value(sample.position - step));
    gradient += scene.grid.directions[axis] * ((ahead - behind) / (2.0 * scene.grid.spacing[axis]));
  }
  const double length = glm::length(gradient);
  result.normal = length > 0.0 ? -gradient / length : Vector(0.0);
  result.coefficient = std::min(length * scene.unitDistance, optics::LargestSpecularCoefficient);
  return result;
}
}

//------------------------------------------------------------------------------
Vector AmbientLight(const Scene& scene, const Sample& sample)
{
  return scene.ambientColor * (scene.visibility ? scene.visibility(sample.position, sample.toViewer) : 1.0);
}

//------------------------------------------------------------------------------
double ShareOfLight(const Scene& scene, const Light& light, const Vector& point)
{
  return scene.shadow ? scene.shadow(light, point) : 1.0;
}

//------------------------------------------------------------------------------
Illumination IlluminationAt(const Scene& scene, const Light& light, const Vector& point)
{
  if (!light.positional)
  {
    return { light.toLight, ShareOfLight(scene, light, point) };
  }
  const Vector offset = light.position - point;
  const double length = glm::length(offset);
  if (length == 0.0)
  {
    return { light.toLight, 0.0 };
  }
  Illumination result;
  result.toLight = offset / length;
  const double distance = length * scene.worldScale;
  result.factor = ShareOfLight(scene, light, point) /
    glm::dot(light.attenuation, Vector(1.0, distance, distance * distance));
  if (light.coneAngle <= 90.0)
  {
    const double cosine = glm::dot(-result.toLight, light.coneAxis);
    const bool isInside = cosine >= std::cos(glm::radians(light.coneAngle));
    result.factor *= isInside ? std::pow(std::max(cosine, 0.0), light.exponent) : 0.0;
  }
  return result;
}

//------------------------------------------------------------------------------
double ShareBehind(const Scene& scene, const Sample& sample, const Vector& toLight)
{
  const Vector gradient = PairGradientAt(scene, sample);
  const double length = glm::length(gradient);
  return scene.transmittedLight != TransmittedLight::Off && length > 0.0
    ? optics::ShareBehind(gradient / length, toLight, sample.toViewer)
    : 0.0;
}

//------------------------------------------------------------------------------
ExtinctionGradient ExtinctionGradientAt(const Scene& scene, const Sample& sample)
{
  if (sample.isSurface)
  {
    ExtinctionGradient surface;
    surface.frame = scene.frames->At(sample.position);
    surface.normal = surface.frame.normal;
    surface.coefficient = 1.0;
    return surface;
  }
  ExtinctionGradient result = scene.gradientEstimate == GradientEstimate::StoredNormal
    ? FromStoredNormal(scene, sample)
    : FromCentralDifferences(scene, sample);
  if (scene.integrationSpace == IntegrationSpace::Data)
  {
    // |tau'| u^2 as a difference over one unit u of data
    const double half = 0.5 * scene.EffectiveUnitInterval();
    result.coefficient = optics::SpecularCoefficient(
      DepthOf(scene, sample.scalar + half), DepthOf(scene, sample.scalar - half), 2.0);
  }
  if (!scene.specularFromExtinction)
  {
    result.coefficient = 1.0;
  }
  return result;
}

namespace
{
// Whether the mapper lights in place of VTK, whose model it is: something else about the light is not VTK's.
bool IsRelit(const Scene& scene)
{
  return scene.lighting || scene.transmittedLight != TransmittedLight::Off || scene.shadow ||
    scene.visibility || scene.ambientColor != Vector(1.0);
}

// Of a model other than VTK's; hybrid normals turn the extinction's.
LightingCoefficients CoefficientsAt(const Scene& scene, const Sample& sample, ExtinctionGradient& extinction)
{
  if (!scene.lighting)
  {
    return { scene.ambient, scene.diffuse, scene.specular };
  }
  const Vector gradient = PairGradientAt(scene, sample);
  LightingCoefficients coefficients = LightingCoefficientsAt(scene, sample, gradient);
  if (scene.hybridNormals && coefficients.side * glm::dot(extinction.normal, gradient) > 0.0)
  {
    extinction.normal = -extinction.normal;
  }
  coefficients.specular *= std::abs(coefficients.side);
  return coefficients;
}

// Ambient and reflected light.
Vector Reflected(const Scene& scene, const Sample& sample, const Vector& color)
{
  if (scene.reflectance == Reflectance::VTK && IsRelit(scene))
  {
    return PhongRadiance(scene, sample, color);
  }
  if (scene.reflectance == Reflectance::VTK)
  {
    const bool isHeadlight =
      scene.lights.size() == 1 && scene.lights[0].headlight && !scene.lights[0].positional;
    return isHeadlight ? HeadlightPhong(scene, sample, color) : VTKPhong(scene, sample, color);
  }
  ExtinctionGradient extinction;
  if (scene.reflectance != Reflectance::None)
  {
    extinction = ExtinctionGradientAt(scene, sample);
  }
  const LightingCoefficients coefficients = CoefficientsAt(scene, sample, extinction);
  Vector diffuse(0.0);
  Vector specular(0.0);
  for (const Light& light : scene.lights)
  {
    Illumination illumination = IlluminationAt(scene, light, sample.position);
    illumination.factor *= 1.0 - ShareBehind(scene, sample, illumination.toLight);
    const double cosTheta = -glm::dot(illumination.toLight, sample.toViewer);
    diffuse +=
      illumination.factor * optics::HenyeyGreenstein(scene.scatteringAnisotropy, cosTheta) * light.diffuse;
    // without a normal nothing is reflected
    if (extinction.coefficient > 0.0 && extinction.normal != Vector(0.0))
    {
      specular += illumination.factor * extinction.coefficient *
        ReflectedBy(scene, extinction, extinction.normal, illumination.toLight, sample.toViewer) *
        light.specular;
    }
  }
  return color * (coefficients.ambient * AmbientLight(scene, sample) + coefficients.diffuse * diffuse) +
    coefficients.specular * specular;
}
}

//------------------------------------------------------------------------------
Vector Radiance(const Scene& scene, const Sample& sample)
{
  return Radiance(scene, sample, scene.Color(sample.scalar), 0.0);
}

//------------------------------------------------------------------------------
Vector Radiance(const Scene& scene, const Sample& sample, const Vector& color, double transmittedShare)
{
  if (!scene.shade)
  {
    return color * AmbientLight(scene, sample);
  }
  const Vector through = transmittedShare > 0.0
    ? color * (TransmissionAt(scene, sample) * transmittedShare * Transmitted(scene, sample))
    : Vector(0.0);
  return Reflected(scene, sample, color) + through;
}
}
