// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameTerm.h"

#include "RayUniforms.h"
#include "SceneNeeds.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <string>

namespace
{
// Map and Components both have three numbers: the first one's name tells.
OpticsFeature StorageFeature(vtkDataArray* anisotropy)
{
  if (anisotropy->GetNumberOfComponents() == 5)
  {
    return OpticsFeature::AnisotropyWorld;
  }
  const char* name = anisotropy->GetComponentName(0);
  const bool isComponents = name && std::string(name) == "C11";
  return isComponents ? OpticsFeature::AnisotropyComponents : OpticsFeature::AnisotropyMap;
}
}

//------------------------------------------------------------------------------
bool FrameTerm::IsActive(const OpticsScene& scene)
{
  return NeedsFrames(scene) || NeedsScalarGradient(scene);
}

//------------------------------------------------------------------------------
bool FrameTerm::Prepare(const OpticsScene& scene)
{
  if (!NeedsFrames(scene))
  {
    this->Textures.Release(scene.Window);
    this->HasTextures = false;
    return true;
  }
  this->HasTextures = this->PrepareTextures(scene);
  return this->HasTextures;
}

//------------------------------------------------------------------------------
bool FrameTerm::PrepareTextures(const OpticsScene& scene)
{
  FrameProvider::Request request;
  request.Anisotropy = IsAnisotropic(scene);
  request.Curvature =
    request.Anisotropy && scene.Optics->GetFrameSource() == vtkOpticsVolumeProperty::Curvature;
  request.ResolutionFactor = scene.Mapper->GetFrameResolutionFactor();
  request.Bits = scene.Mapper->GetFramePrecision();
  request.Coarse = scene.Mapper->IsInteractive(scene.Renderer);
  const FrameGrid grid = this->Provider.Update(scene, request);
  if (!grid.Normals)
  {
    return false;
  }
  if (grid.Anisotropy)
  {
    this->Storage = StorageFeature(grid.Anisotropy);
  }
  if (!this->Textures.Update(grid, request.Bits, scene.Window))
  {
    scene.Mapper->Say("The normals have more voxels on an axis than the OpenGL of this machine has texels (" +
      std::to_string(vtkTextureObject::GetMaximumTextureSize3D(scene.Window)) +
      "): the picture is VTK's own. Lower SetFrameResolutionFactor().");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FrameTerm::Serves(const OpticsScene& scene) const
{
  return this->HasTextures || !NeedsFrames(scene);
}

//------------------------------------------------------------------------------
void FrameTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  if (NeedsFrames(scene))
  {
    features.Add(OpticsFeature::Ray);
    features.Add(OpticsFeature::FrameLookup);
  }
  if (NeedsScalarGradient(scene))
  {
    features.Add(OpticsFeature::SampleScalar);
    features.Add(StoresScalarGradient(scene) ? OpticsFeature::ScalarGradientStored
                                             : OpticsFeature::ScalarGradientCentral);
  }
  if (IsAnisotropic(scene))
  {
    features.Add(this->Storage);
  }
}

//------------------------------------------------------------------------------
void FrameTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  const double step = SmallestSpacing(scene);
  if (NeedsFrames(scene))
  {
    double range[2];
    scene.Mapper->GetLoadedScalarRange(scene.OpacityComponent, range);
    this->Textures.SetUniforms(program, step / (range[1] > range[0] ? range[1] - range[0] : 1.0));
  }
  if (NeedsScalarGradient(scene))
  {
    SetScalarUniforms(scene, program);
    SetDifferences(scene, step, "in_opticsDifferenceToStep", program);
  }
}
