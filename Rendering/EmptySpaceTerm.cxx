// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmptySpaceTerm.h"

#include "SceneNeeds.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of the cells: where less is empty, looking for it costs more than it saves.
const double LeastEmptyFraction = 0.1;

vtkImageData* Image(const OpticsScene& scene)
{
  return vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
}

void FindDimensions(const OpticsScene& scene, int dimensions[3])
{
  Image(scene)->GetDimensions(dimensions);
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] -= scene.CellScalars ? 1 : 0;
  }
}

// The user's own text may draw what has no opacity.
bool HasOwnShader(const OpticsScene& scene)
{
  return scene.Volume->GetShaderProperty()->GetNumberOfShaderReplacements() > 0;
}

// A sample without an opacity by VTK's own function of the scalar is not seen.
bool IsSeenByScalar(const OpticsScene& scene)
{
  return !WantsIntegral(scene) && !WantsClassification(scene) && !HasLabels(scene) && !Is2D(scene) &&
    !scene.Mapper->GetUseDepthPass() && scene.Scalars->GetNumberOfComponents() != 3 &&
    scene.Volume->GetProperty()->GetScalarOpacity()->GetSize() > 0;
}

// As VTK's look-up table.
std::vector<float> MakeOpacityTable(const OpticsScene& scene, const double dataRange[2])
{
  vtkPiecewiseFunction* function = scene.Volume->GetProperty()->GetScalarOpacity();
  double range[2] = { dataRange[0], dataRange[1] };
  if (scene.Mapper->GetScalarOpacityRangeType() == vtkGPUVolumeRayCastMapper::NATIVE)
  {
    function->GetRange(range);
  }
  const int wanted = vtkMath::NearestPowerOfTwo(function->EstimateMinNumberOfSamples(range[0], range[1]));
  const int largest = vtkTextureObject::GetMaximumTextureSize(scene.Window);
  std::vector<float> table(std::min(std::max(wanted, 1024), std::max(largest, 1024)));
  function->GetTable(range[0], range[1], static_cast<int>(table.size()), table.data());
  return table;
}

// The range that VTK loads, in the scalars that its coordinates 0 and 1 stand for: codes of 8 and 16 bits count as one
// more than there are.
void FindCoordinateRange(const OpticsScene& scene, const double dataRange[2], double range[2])
{
  const bool isCode = scene.Scalars->GetDataTypeSize() <= 2;
  const double largest = isCode ? scene.Scalars->GetDataTypeMax() : 0.0;
  const double factor = isCode ? largest / (largest + 1.0) : 1.0;
  range[0] = dataRange[0] * factor;
  range[1] = dataRange[1] * factor;
}
}

//------------------------------------------------------------------------------
bool EmptySpaceTerm::IsActive(const OpticsScene& scene)
{
  return scene.Mapper->GetSkipEmptySpace() && FindUnsupported(scene).empty() &&
    IsSeenByScalar(scene) && !scene.Mapper->HasPartitions() && !HasOwnShader(scene);
}

//------------------------------------------------------------------------------
bool EmptySpaceTerm::Prepare(const OpticsScene& scene)
{
  int dimensions[3];
  FindDimensions(scene, dimensions);
  this->Grid->SetCellSize(scene.Mapper->GetMacrocellSize());
  this->Grid->SetScalars(scene.Scalars);
  this->Grid->SetDimensions(dimensions);
  this->Grid->SetComponent(scene.OpacityComponent);
  if (!this->Grid->Update())
  {
    return false;
  }
  this->Classify(scene);
  return this->Grid->GetEmptyFraction() >= LeastEmptyFraction;
}

//------------------------------------------------------------------------------
void EmptySpaceTerm::Classify(const OpticsScene& scene)
{
  double dataRange[2], range[2];
  scene.Scalars->GetFiniteRange(dataRange, scene.OpacityComponent);
  dataRange[0] = static_cast<float>(dataRange[0]); // as VTK keeps them
  dataRange[1] = static_cast<float>(dataRange[1]);
  FindCoordinateRange(scene, dataRange, range);
  if (!(range[1] > range[0]))
  {
    range[1] = range[0] + 1.0;
  }
  const VisibleScalars visible(MakeOpacityTable(scene, dataRange), range, VisibleScalars::Ends::Edges);
  if (!(visible == this->Visible) || this->RangesTime != this->Grid->GetUpdateTime())
  {
    this->Grid->Classify(visible, false);
    this->Visible = visible;
    this->RangesTime = this->Grid->GetUpdateTime();
  }
}

//------------------------------------------------------------------------------
void EmptySpaceTerm::AddFeatures(const OpticsScene&, OpticsFeatures& features)
{
  features.Add(OpticsFeature::EmptySpace);
}

//------------------------------------------------------------------------------
void EmptySpaceTerm::Upload(const OpticsScene& scene, const int size[3], std::vector<unsigned char> distances)
{
  this->Texture.Renew(scene.Window);
  this->Texture->Create3DFromRaw(size[0], size[1], size[2], 1, VTK_UNSIGNED_CHAR, distances.data());
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

//------------------------------------------------------------------------------
void EmptySpaceTerm::UpdateTexture(const OpticsScene& scene)
{
  if (scene.Mapper->HasPartitions())
  {
    const int one[3] = { 1, 1, 1 };
    this->Upload(scene, one, { 0 });
    this->UploadedTime = 0;
  }
  else if (!this->Texture.IsAlive(scene.Window) || this->UploadedTime != this->Grid->GetClassifyTime())
  {
    int size[3];
    this->Grid->GetGridSize(size);
    this->Upload(scene, size, this->Grid->GetDistances());
    this->UploadedTime = this->Grid->GetClassifyTime();
  }
}

//------------------------------------------------------------------------------
// That VTK loads the volume in partitions is known only now, in a mapper's first frame: one cell, not empty.
void EmptySpaceTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  this->UpdateTexture(scene);
  int dimensions[3];
  this->Grid->GetDimensions(dimensions);
  float cells[3] = {};
  for (int axis = 0; axis < 3 && !scene.Mapper->HasPartitions(); ++axis)
  {
    cells[axis] = static_cast<float>(static_cast<double>(dimensions[axis]) / this->Grid->GetCellSize());
  }
  program->SetUniform3f("in_opticsMacrocells", cells);
  this->Texture.Bind("in_opticsDistances", program);
}

//------------------------------------------------------------------------------
std::size_t EmptySpaceTerm::GetMemorySize() const
{
  return this->Texture
    ? std::size_t(1) * this->Texture->GetWidth() * this->Texture->GetHeight() * this->Texture->GetDepth()
    : 0;
}
