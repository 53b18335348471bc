// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "IntegrationTerm.h"

#include "FrameTerm.h"
#include "RayUniforms.h"
#include "SceneNeeds.h"
#include "TransferFunctionTerm.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkDataArray.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <string>

namespace
{
using Property = vtkOpticsVolumeProperty;
using F = OpticsFeature;

void AddSilhouetteFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  // of a sample's own attenuation Exact is the same as Gradient
  const F silhouettes[] = { F::SilhouetteOff, F::SilhouetteExact, F::SilhouetteClamped, F::SilhouetteExact };
  if (HasSilhouettes(scene))
  {
    features.Add(F::SilhouetteOn);
    features.Add(F::Ray);
    features.Add(silhouettes[scene.Optics->GetSilhouette()]);
  }
  else
  {
    features.Add(F::SilhouetteOff);
  }
}

}

//------------------------------------------------------------------------------
bool IntegrationTerm::IsActive(const OpticsScene& scene)
{
  if (!WantsIntegral(scene))
  {
    return false;
  }
  const std::string reason = FindUnsupportedByIntegral(scene);
  if (!reason.empty())
  {
    scene.Mapper->Say("The integral in data space or by a pre-integrated table does not support " + reason +
      ": opacity is VTK's own. SetIntegrationSpaceToPhysical() and SetClassificationToPost() silence this.");
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool IntegrationTerm::Prepare(const OpticsScene& scene)
{
  return this->Frames.Serves(scene);
}

//------------------------------------------------------------------------------
void IntegrationTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(F::Integral);
  features.Add(F::SampleScalar);
  features.Add(F::OpacityFormulas);
  features.Add(F::DataSpaceFormulas);
  features.Add(IsPreIntegrated(scene) ? F::IntegralPreIntegrated : F::IntegralPost);
  features.Add(IntegratesInData(scene) ? F::IntegralInData : F::IntegralInSpace);
  const F colors[] = { F::ColorOfSegment, F::ColorOfFirst, F::ColorOfSample };
  features.Add(colors[std::clamp(scene.Scalars->GetNumberOfComponents() - 1, 0, 2)]);
  if (!NeedsColorTable(scene))
  {
    features.Add(F::NoColorTable);
  }
  features.Add(TransmitsLight(scene) ? F::Transmitted : F::TransmittedNone);
  features.Add(scene.Mapper->GetCropping() ? F::HiddenByCropping : F::HiddenHalf);
  features.Add(HasIsosurfaces(scene) ? F::Isosurfaces : F::IsosurfacesNone);
  AddSilhouetteFeatures(scene, features);
}

//------------------------------------------------------------------------------
void IntegrationTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  SetScalarUniforms(scene, program);
  if (HasSilhouettes(scene))
  {
    SetSpaceUniforms(scene, program);
    program->SetUniformf("in_opticsGradientStepInverse", static_cast<float>(1.0 / SmallestSpacing(scene)));
  }
  const double units = UnitsPerRange(scene);
  program->SetUniformf("in_opticsUnitsPerRange", static_cast<float>(units));
  program->SetUniformf("in_opticsHalfUnit", static_cast<float>(std::min(0.5 / units, 1.0)));
  program->SetUniformf("in_opticsUnitDistanceInverse", static_cast<float>(1.0 / UnitDistance(scene)));
  const bool isSpecular = scene.Optics->GetTransmittedLight() == Property::DiffuseAndSpecular;
  program->SetUniformf("in_opticsTransmittedSpecular", isSpecular ? 1.0F : 0.0F);
  if (IsPreIntegrated(scene) || TransmitsLight(scene))
  {
    this->Table.Update(scene);
    this->Table.SetUniforms(scene, program);
  }
  if (HasIsosurfaces(scene))
  {
    this->Isosurfaces.Update(scene);
    this->Isosurfaces.SetUniforms(program);
  }
}

//------------------------------------------------------------------------------
void IntegrationTerm::UnbindTextures()
{
  this->Table.Unbind();
  this->Isosurfaces.Unbind();
}

//------------------------------------------------------------------------------
void IntegrationTerm::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Table.Release(window);
  this->Isosurfaces.Release(window);
}

//------------------------------------------------------------------------------
std::size_t IntegrationTerm::GetMemorySize() const
{
  return this->Table.GetMemorySize() + this->Isosurfaces.GetMemorySize();
}
