// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TransferFunctionTerm.h"

#include "RayUniforms.h"
#include "SceneNeeds.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
template <typename Function>
void TableRange(const OpticsScene& scene, int rangeType, int component, Function* function, double range[2])
{
  ScalarRange(scene, component, range);
  if (rangeType == vtkGPUVolumeRayCastMapper::NATIVE)
  {
    function->GetRange(range);
    WidenEmptyRange(range); // of a function of one node
  }
}
}

//------------------------------------------------------------------------------
void TransferFunctionTerm::GetOpacityRange(const OpticsScene& scene, double range[2])
{
  TableRange(scene, scene.Mapper->GetScalarOpacityRangeType(), scene.OpacityComponent,
    scene.Volume->GetProperty()->GetScalarOpacity(), range);
}

//------------------------------------------------------------------------------
void TransferFunctionTerm::GetColorRange(const OpticsScene& scene, double range[2])
{
  TableRange(scene, scene.Mapper->GetColorRangeType(), 0,
    scene.Volume->GetProperty()->GetRGBTransferFunction(), range);
}

//------------------------------------------------------------------------------
bool TransferFunctionTerm::IsActive(const OpticsScene& scene)
{
  return NeedsOpacityTable(scene) || NeedsColorTable(scene);
}

//------------------------------------------------------------------------------
void TransferFunctionTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  if (NeedsOpacityTable(scene))
  {
    features.Add(OpticsFeature::OpacityTable);
  }
  if (NeedsColorTable(scene))
  {
    features.Add(OpticsFeature::ColorTable);
  }
}

//------------------------------------------------------------------------------
void TransferFunctionTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  double range[2];
  if (NeedsOpacityTable(scene))
  {
    GetOpacityRange(scene, range);
    this->Opacity.Update(property->GetScalarOpacity(), range, scene.Window);
    this->Opacity.SetUniforms("in_opticsOpacityTable", program);
  }
  if (NeedsColorTable(scene))
  {
    GetColorRange(scene, range);
    this->Color.Update(property->GetRGBTransferFunction(), range, scene.Window);
    this->Color.SetUniforms("in_opticsColorTable", program);
  }
}

//------------------------------------------------------------------------------
void TransferFunctionTerm::UnbindTextures()
{
  this->Opacity.Unbind();
  this->Color.Unbind();
}

//------------------------------------------------------------------------------
void TransferFunctionTerm::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Opacity.Release(window);
  this->Color.Release(window);
}

//------------------------------------------------------------------------------
std::size_t TransferFunctionTerm::GetMemorySize() const
{
  return this->Opacity.GetMemorySize() + this->Color.GetMemorySize();
}
