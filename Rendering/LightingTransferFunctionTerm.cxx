// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingTransferFunctionTerm.h"

#include "FrameTerm.h"
#include "RayUniforms.h"
#include "ScalarPair.h"
#include "SceneNeeds.h"
#include "vtkLightingTransferFunction.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

//------------------------------------------------------------------------------
bool LightingTransferFunctionTerm::IsActive(const OpticsScene& scene)
{
  const bool isActive = HasLightingTable(scene);
  if (isActive && scene.Optics->GetHybridNormals() && Is2D(scene))
  {
    scene.Mapper->Say("HybridNormals need a scalar opacity function, which a 2D transfer function is "
                      "not: light is that of the renderer's two-sided lighting. HybridNormalsOff() "
                      "silences this.");
  }
  return isActive;
}

//------------------------------------------------------------------------------
bool LightingTransferFunctionTerm::Prepare(const OpticsScene& scene)
{
  return this->Frames.Serves(scene);
}

//------------------------------------------------------------------------------
void LightingTransferFunctionTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(OpticsFeature::CoefficientsOfTable);
  AddScalarPairFeatures(scene, features);
  if (HasHybridNormals(scene))
  {
    features.Add(OpticsFeature::HybridNormals);
    if (scene.Optics->GetReflectanceModel() == vtkOpticsVolumeProperty::VTK)
    {
      features.Add(OpticsFeature::HybridDiffuse);
    }
  }
}

//------------------------------------------------------------------------------
// The loaded range is known once VTK has loaded the volume: not before the first draw.
void LightingTransferFunctionTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  LightingTableTexture::Request request;
  request.Function = scene.Optics->GetLightingTransferFunction();
  request.Density = HasHybridNormals(scene) ? scene.Volume->GetProperty()->GetScalarOpacity() : nullptr;
  CoordinateRange(scene, request.Range);
  request.Size = scene.Mapper->GetLightingTableSize();
  request.Bits = scene.Mapper->GetTablePrecision();
  this->Table.Update(request, scene.Window);
  this->Table.SetUniforms(program);
  program->SetUniformf("in_opticsLightScale", static_cast<float>(scene.Optics->GetLightScale()));
  SetScalarPairUniforms(scene, program);
}
