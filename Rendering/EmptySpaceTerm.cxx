// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmptySpaceTerm.h"

#include "SceneNeeds.h"
#include "VisibleInScene.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
// Of the cells: where less is empty, looking for it costs more than it saves. A sample that is lit, or whose gradient is
// needed, costs several times as much as one that is only looked up.
double LeastEmptyFraction(const OpticsScene& scene)
{
  const bool needsGradient = scene.Volume->GetProperty()->GetShade() || HasGradientOpacity(scene) ||
    Is2D(scene) || ReplacesIntegral(scene);
  return needsGradient ? 0.1 : 0.3;
}

void FindDimensions(const OpticsScene& scene, int dimensions[3])
{
  vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetDimensions(dimensions);
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
}

//------------------------------------------------------------------------------
bool EmptySpaceTerm::IsActive(const OpticsScene& scene)
{
  const bool isServed = scene.Mapper->GetSkipEmptySpace() && FindUnsupportedBySamples(scene).empty() &&
    IsSeenByScalars(scene) && !scene.Mapper->HasPartitions() && !HasOwnShader(scene);
  if (!isServed)
  {
    this->Grid->SetScalars(nullptr); // nor keeps them from being deleted
  }
  return isServed;
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
  return this->Grid->GetEmptyFraction() >= LeastEmptyFraction(scene);
}

//------------------------------------------------------------------------------
void EmptySpaceTerm::Classify(const OpticsScene& scene)
{
  const VisibleScalars visible = FindVisibleScalars(scene);
  const VisibleScalars visibleWhereConstant = FindVisibleWhereConstant(scene);
  const bool isCurrent = visible == this->Visible && visibleWhereConstant == this->VisibleWhereConstant &&
    this->RangesTime == this->Grid->GetUpdateTime();
  if (!isCurrent)
  {
    this->Grid->Classify(visible, visibleWhereConstant);
    this->Visible = visible;
    this->VisibleWhereConstant = visibleWhereConstant;
    this->RangesTime = this->Grid->GetUpdateTime();
  }
}

//------------------------------------------------------------------------------
// The integral is the last term before this one; without what it draws with it is VTK's own, after all, and the cells
// are not of that.
void EmptySpaceTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  const bool isIntegral = features.Has(OpticsFeature::Integral);
  if (isIntegral == ReplacesIntegral(scene))
  {
    features.Add(OpticsFeature::EmptySpace);
    features.Add(isIntegral ? OpticsFeature::EmptySpaceOfSegments : OpticsFeature::EmptySpaceOfSamples);
  }
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
