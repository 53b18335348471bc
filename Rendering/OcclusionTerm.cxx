// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OcclusionTerm.h"

#include "OcclusionGathering.h"
#include "Optics.h"
#include "SceneNeeds.h"
#include "SweepViews.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"

#include <cmath>
#include <string>

namespace
{
using F = OpticsFeature;
}

//------------------------------------------------------------------------------
OcclusionTerm::OcclusionTerm() = default;

//------------------------------------------------------------------------------
OcclusionTerm::~OcclusionTerm() = default;

//------------------------------------------------------------------------------
bool OcclusionTerm::IsActive(const OpticsScene& scene)
{
  if (!WantsAmbientLight(scene))
  {
    return false;
  }
  const std::string reason = FindUnsupported(scene);
  if (!reason.empty())
  {
    scene.Mapper->Say("Occlusion and AmbientColor do not support " + reason +
      ": ambient light is VTK's own. OcclusionOff() and SetAmbientColor(1, 1, 1) silence this.");
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool OcclusionTerm::Prepare(const OpticsScene&)
{
  return true;
}

//------------------------------------------------------------------------------
void OcclusionTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(F::AmbientLight);
  if (HasOcclusion(scene))
  {
    AddSweepFeatures(scene, features);
    GathersOcclusion(scene) ? AddGatheringFeatures(scene, features) : features.Add(F::Occlusion);
    features.Add(IntegratesInData(scene) ? F::OwnOpacityInData : F::OwnOpacity);
  }
  else
  {
    features.Add(F::OcclusionNone);
  }
  if (!scene.Volume->GetProperty()->GetShade())
  {
    features.Add(F::AmbientAlone);
    features.Add(
      HasGradientOpacity(scene) && !Is2D(scene) ? F::GradientOpacityScalar : F::GradientOpacityNone);
  }
}

//------------------------------------------------------------------------------
void OcclusionTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  program->SetUniform3f("in_opticsAmbientColor", scene.Optics->GetAmbientColor());
}

//------------------------------------------------------------------------------
void OcclusionTerm::BeforeDraw(const OpticsScene& scene, vtkShaderProgram* program)
{
  if (!HasOcclusion(scene))
  {
    return;
  }
  double corners[24];
  VolumeCorners(scene, corners);
  const SweepGrid grid(CameraView(scene), corners, SweepResolution(scene));
  vtkVisibilitySweep::Volume volume = SweptVolume(scene, program);
  if (GathersOcclusion(scene))
  {
    SetGatheringReach(grid, volume);
  }
  const bool isSwept = this->Sweep(scene, volume, grid);
  vtkTextureObject* texture = isSwept ? this->Eye->GetTexture() : scene.Mapper->GetVolumeTexture();
  texture->Activate(); // a sampler needs some texture of its kind
  program->SetUniformi("in_opticsOcclusion", texture->GetTextureUnit());
  SetGridUniform(grid, volume, "in_opticsOcclusionGrid", program, GathersOcclusion(scene));
  if (GathersOcclusion(scene))
  {
    SetGatheringUniforms(scene, volume, grid, isSwept, program);
  }
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(this->Eye->GetConeAngle()));
  const double numbers[3] = { 1.0 * grid.GetSize()[2], optics::MeanWayOut(cosine), isSwept ? 1.0 : 0.0 };
  program->SetUniform3f("in_opticsOcclusionNumbers", numbers);
  this->IsBound = isSwept;
}

//------------------------------------------------------------------------------
bool OcclusionTerm::Sweep(
  const OpticsScene& scene, const vtkVisibilitySweep::Volume& volume, const SweepGrid& grid)
{
  if (IsSelection(scene))
  {
    return false;
  }
  const std::string reason = FindUnsweepable(scene);
  if (!reason.empty())
  {
    scene.Mapper->Say("Occlusion is left out: " + reason + " OcclusionOff() silences this.");
    return false;
  }
  SetSweepKnobs(scene, this->Eye);
  this->Eye->SetKeepDirections(GathersOcclusion(scene));
  this->Eye->SetConeAngle(scene.Optics->GetOcclusionAngle());
  const bool isSwept = this->Eye->Sweep(volume, grid);
  if (!isSwept && !grid.IsEmpty())
  {
    scene.Mapper->Say("Occlusion is left out: this OpenGL does not draw on the " +
      std::to_string(scene.Mapper->GetVisibilityPrecision()) +
      "-bit textures that it is found in, or does not link its shader program. Try another "
      "SetVisibilityPrecision(); OcclusionOff() silences this.");
  }
  return isSwept;
}

//------------------------------------------------------------------------------
void OcclusionTerm::UnbindTextures()
{
  if (this->IsBound)
  {
    this->Eye->GetTexture()->Deactivate();
    this->IsBound = false;
  }
}

//------------------------------------------------------------------------------
void OcclusionTerm::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Eye->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
std::size_t OcclusionTerm::GetMemorySize() const
{
  return this->Eye->GetMemorySize();
}
