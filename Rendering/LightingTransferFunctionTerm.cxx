// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingTransferFunctionTerm.h"

#include "ReflectanceTerm.h"
#include "vtkLightingTransferFunction.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

namespace
{
using Property = vtkOpticsVolumeProperty;

bool Is2D(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
}

bool FetchesPair(const OpticsScene& scene)
{
  return scene.Mapper->GetLightingSamples() == vtkOpticsVolumeMapper::Fetched;
}

// A step along a unit vector of data space, to voxels. A matrix set by rows is transposed for OpenGL.
void SetStepToVoxels(const OpticsScene& scene, vtkShaderProgram* program)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const double step = scene.Optics->GetGradientStepLength() * SmallestSpacing(scene);
  vtkNew<vtkMatrix3x3> transposed;
  for (int i = 0; i < 9; ++i)
  {
    const double voxels = step / image->GetSpacing()[i % 3];
    transposed->SetElement(i / 3, i % 3, image->GetDirectionMatrix()->GetElement(i / 3, i % 3) * voxels);
  }
  program->SetUniformMatrix("in_opticsStepToVoxels", transposed);
}
}

//------------------------------------------------------------------------------
bool LightingTransferFunctionTerm::HasHybridNormals(const OpticsScene& scene)
{
  return scene.Optics->GetLightingTransferFunction() && scene.Optics->GetHybridNormals() && !Is2D(scene) &&
    scene.Optics->GetReflectanceModel() != Property::None;
}

//------------------------------------------------------------------------------
bool LightingTransferFunctionTerm::IsActive(const OpticsScene& scene)
{
  const bool isActive = scene.Optics->GetLightingTransferFunction() && this->Light.LightsScene();
  if (isActive && scene.Optics->GetHybridNormals() && Is2D(scene))
  {
    scene.Mapper->Say("HybridNormals need a scalar opacity function, which a 2D transfer function is "
                      "not: light is that of the renderer's two-sided lighting. HybridNormalsOff() "
                      "silences this.");
  }
  return isActive;
}

//------------------------------------------------------------------------------
bool LightingTransferFunctionTerm::Prepare(const OpticsScene&)
{
  return true;
}

//------------------------------------------------------------------------------
void LightingTransferFunctionTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(OpticsFeature::CoefficientsOfTable);
  if (FetchesPair(scene))
  {
    features.Add(OpticsFeature::ScalarLookup);
    features.Add(OpticsFeature::ScalarPairFetched);
  }
  else
  {
    features.Add(OpticsFeature::ScalarPairExtrapolated);
  }
  if (HasHybridNormals(scene))
  {
    features.Add(OpticsFeature::HybridNormals);
    if (scene.Optics->GetReflectanceModel() == Property::VTK)
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
  request.Density =
    HasHybridNormals(scene) ? scene.Volume->GetProperty()->GetScalarOpacity() : nullptr;
  scene.Mapper->GetLoadedScalarRange(scene.OpacityComponent, request.Range);
  request.Range[1] = request.Range[1] > request.Range[0] ? request.Range[1] : request.Range[0] + 1.0;
  request.Size = scene.Mapper->GetLightingTableSize();
  request.Bits = scene.Mapper->GetTablePrecision();
  this->Table.Update(request, scene.Window);
  this->Table.SetUniforms(program);
  program->SetUniformf("in_opticsLightScale", static_cast<float>(scene.Optics->GetLightScale()));
  if (FetchesPair(scene))
  {
    SetStepToVoxels(scene, program);
  }
  else
  {
    program->SetUniformf("in_opticsPairStep", static_cast<float>(scene.Optics->GetGradientStepLength()));
  }
}
