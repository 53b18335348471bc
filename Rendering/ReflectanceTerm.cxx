// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReflectanceTerm.h"

#include "FrameTerm.h"
#include "LightUniforms.h"
#include "RayUniforms.h"
#include "SceneNeeds.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <string>

namespace
{
using Property = vtkOpticsVolumeProperty;

OpticsFeature ModelFeature(int model)
{
  const OpticsFeature features[] = { OpticsFeature::ReflectanceVTK, OpticsFeature::ReflectanceNone,
    OpticsFeature::ReflectanceBlinnPhong, OpticsFeature::ReflectanceWard,
    OpticsFeature::ReflectanceLafortune };
  return features[model];
}

void AddExtinctionFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  if (NeedsCentralDifferences(scene))
  {
    features.Add(OpticsFeature::GradientCentral);
    features.Add(NeedsFrames(scene) ? OpticsFeature::GradientCentralWithNormal
                                    : OpticsFeature::GradientCentralWithoutNormal);
  }
  else
  {
    features.Add(OpticsFeature::GradientStored);
  }
  features.Add(Is2D(scene)        ? OpticsFeature::OpacityAt2D
      : HasLabels(scene)          ? OpticsFeature::OpacityAtLabel
      : HasGradientOpacity(scene) ? OpticsFeature::OpacityAtScalarAndGradient
                                  : OpticsFeature::OpacityAtScalar);
}

void AddSurfaceFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  if (HasSurface(scene) || TransmitsLight(scene))
  {
    features.Add(OpticsFeature::Surface);
  }
  if (HasExtinctionSurface(scene))
  {
    features.Add(OpticsFeature::ExtinctionSurface);
    features.Add(OpticsFeature::OpacityFormulas);
    features.Add(IntegratesInData(scene) ? OpticsFeature::SurfaceInData : OpticsFeature::SurfaceOfExtinction);
    AddExtinctionFeatures(scene, features);
  }
  if (IsAnisotropic(scene))
  {
    features.Add(OpticsFeature::Anisotropic);
  }
}

void SetSurfaceUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  Property* optics = scene.Optics;
  program->SetUniformf("in_opticsSpecularFromExtinction", optics->GetSpecularFromExtinction() ? 1.0F : 0.0F);
  program->SetUniformf("in_opticsGlossiness", static_cast<float>(optics->GetGlossiness()));
  program->SetUniformf("in_opticsAnisotropyScale", static_cast<float>(optics->GetAnisotropyScale()));
}

void SetExtinctionUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  const double step = SmallestSpacing(scene);
  if (NeedsCentralDifferences(scene))
  {
    SetDifferences(scene, UnitDistance(scene), "in_opticsDifferenceToData", program);
  }
  program->SetUniformf("in_opticsUnitStep", static_cast<float>(UnitDistance(scene) / step));
  const double* spacing = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetSpacing();
  const double meanSpacing = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  program->SetUniformf("in_opticsChangeToVTK", static_cast<float>(4.0 * meanSpacing / step));
}

bool HasOwnModel(const OpticsScene& scene)
{
  return scene.Optics->GetReflectanceModel() != Property::VTK;
}

void SayUnsupported(const OpticsScene& scene, const std::string& reason)
{
  const bool hasModel = HasOwnModel(scene);
  const std::string who = hasModel
    ? std::string("Reflectance model ") + scene.Optics->GetReflectanceModelAsString()
    : std::string("The lighting transfer function");
  const std::string remedy = hasModel ? "SetReflectanceModelToVTK()" : "SetLightingTransferFunction(nullptr)";
  scene.Mapper->Say(
    who + " does not support " + reason + ": the picture is VTK's own. " + remedy + " silences this.");
}
}

//------------------------------------------------------------------------------
bool ReflectanceTerm::IsActive(const OpticsScene& scene)
{
  if (!WantsLighting(scene))
  {
    return false;
  }
  const std::string reason = FindUnsupportedBySamples(scene);
  if (!reason.empty() && (HasOwnModel(scene) || scene.Optics->GetLightingTransferFunction()))
  {
    SayUnsupported(scene, reason);
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool ReflectanceTerm::Prepare(const OpticsScene& scene)
{
  return this->Frames.Serves(scene);
}

//------------------------------------------------------------------------------
void ReflectanceTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(OpticsFeature::Reflectance);
  features.Add(OpticsFeature::Ray);
  features.Add(OpticsFeature::SampleScalar);
  features.Add(ModelFeature(scene.Optics->GetReflectanceModel()));
  if (!HasLightingTable(scene))
  {
    features.Add(OpticsFeature::CoefficientsOfProperty);
  }
  features.NumberOfLights = CountLights(scene.Renderer);
  features.Add(
    HasPositionalLight(scene.Renderer) ? OpticsFeature::LightsPositional : OpticsFeature::LightsDirectional);
  const bool hasVTKGradientOpacity = HasGradientOpacity(scene) && !Is2D(scene);
  features.Add(
    hasVTKGradientOpacity ? OpticsFeature::GradientOpacityScalar : OpticsFeature::GradientOpacityNone);
  if (scene.Optics->GetReflectanceModel() != Property::VTK)
  {
    features.Add(OpticsFeature::Scattering);
  }
  AddSurfaceFeatures(scene, features);
}

//------------------------------------------------------------------------------
void ReflectanceTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  SetSpaceUniforms(scene, program);
  SetScalarUniforms(scene, program);
  SetLightUniforms(scene.Renderer, program);
  program->SetUniformf("in_opticsScatteringAnisotropy", scene.Optics->GetScatteringAnisotropy());
  const bool isTwoSided = scene.Renderer->GetTwoSidedLighting() && !HasHybridNormals(scene);
  program->SetUniformf("in_opticsTwoSided", isTwoSided ? 1.0F : 0.0F);
  if (HasExtinctionSurface(scene))
  {
    SetSurfaceUniforms(scene, program);
    SetExtinctionUniforms(scene, program);
  }
}
