// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmptySpaceTerm.h"

#include "SceneNeeds.h"
#include "SkippingCost.h"
#include "VisibleGradients.h"
#include "VisibleInScene.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <utility>

namespace
{
// Fits to BenchmarkEmptySpace --holes. A sample that is lit, or whose gradient is needed, takes longer itself.
const SkippingTimes PlainTimes = { 1.47, 0.67, 4.8, 0.18 };
const SkippingTimes GradientTimes = { 1.2, 0.27, 2.4, 0.18 };
const double WorthwhileTime = 0.9; // the estimate is good to a tenth

// How far opacities of the table are of; not where the table only tells what is seen.
double VoxelsPerUnit(const OpticsScene& scene)
{
  const double* spacing = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetSpacing();
  const double voxel = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  return ReplacesIntegral(scene) || Is2D(scene)
    ? 0.0
    : scene.Volume->GetProperty()->GetScalarOpacityUnitDistance() / voxel;
}

bool NeedsGradient(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetShade() || HasGradientOpacity(scene) || Is2D(scene) ||
    ReplacesIntegral(scene);
}

void FindDimensions(const OpticsScene& scene, int dimensions[3])
{
  vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetDimensions(dimensions);
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] -= scene.CellScalars ? 1 : 0;
  }
}

// The mapper tells of it as of its other preparation.
void TellProgress(vtkObject*, unsigned long event, void* mapper, void* data)
{
  const std::pair<unsigned long, unsigned long> events[] = {
    { vtkCommand::StartEvent, vtkCommand::VolumeMapperComputeGradientsStartEvent },
    { vtkCommand::ProgressEvent, vtkCommand::VolumeMapperComputeGradientsProgressEvent },
    { vtkCommand::EndEvent, vtkCommand::VolumeMapperComputeGradientsEndEvent }
  };
  for (const auto& [ofGrid, ofMapper] : events)
  {
    if (event == ofGrid)
    {
      static_cast<vtkOpticsVolumeMapper*>(mapper)->InvokeEvent(ofMapper, data);
    }
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
  this->IsKnown = false;
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
  const int chosen = scene.Mapper->GetMacrocellSize();
  this->Grid->SetCellSize(chosen > 0 ? chosen : vtkMacrocellGrid::FindCellSize(dimensions));
  this->Grid->SetScalars(scene.Scalars);
  this->Grid->SetDimensions(dimensions);
  this->Grid->SetComponent(scene.OpacityComponent);
  double gradientScale[3];
  FindGradientScale(scene, gradientScale);
  this->Grid->SetGradientScale(gradientScale);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(scene.Mapper);
  command->SetCallback(TellProgress);
  const unsigned long tag = this->Grid->AddObserver(vtkCommand::AnyEvent, command);
  const bool hasRanges = this->Grid->Update();
  if (hasRanges)
  {
    this->Classify(scene);
  }
  this->Grid->RemoveObserver(tag);
  this->IsKnown = hasRanges;
  return hasRanges && this->IsWorthwhile(scene);
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
    if (visible.DependsOnGradient())
    {
      this->Grid->UpdateGradients();
    }
    this->Grid->Classify(visible, visibleWhereConstant);
    this->Visible = visible;
    this->VisibleWhereConstant = visibleWhereConstant;
    this->RangesTime = this->Grid->GetUpdateTime();
  }
}

//------------------------------------------------------------------------------
bool EmptySpaceTerm::FindVisibleBox(double box[6]) const
{
  int dimensions[3], cells[6];
  this->Grid->GetDimensions(dimensions);
  this->Grid->GetVisibleExtent(cells);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = static_cast<double>(this->Grid->GetCellSize()) / dimensions[axis];
    box[2 * axis] = side * std::min(cells[2 * axis], cells[2 * axis + 1] + 1);
    box[2 * axis + 1] = side * (cells[2 * axis + 1] + 1);
  }
  return this->IsKnown;
}

//------------------------------------------------------------------------------
// Where less is empty, looking for it costs more than it saves.
bool EmptySpaceTerm::IsWorthwhile(const OpticsScene& scene)
{
  const EstimateOf estimateOf = { this->Grid->GetClassifyTime(), NeedsGradient(scene), VoxelsPerUnit(scene) };
  if (estimateOf != this->LastEstimateOf)
  {
    const SkippingTimes& times = NeedsGradient(scene) ? GradientTimes : PlainTimes;
    this->LastEstimate = EstimateSkipping(this->Grid, this->Visible, VoxelsPerUnit(scene), times);
    this->LastEstimateOf = estimateOf;
  }
  return this->LastEstimate < WorthwhileTime;
}

//------------------------------------------------------------------------------
// The integral is the last term before this one; without what it draws with it is VTK's own, after all, and the cells
// are not of that.
void EmptySpaceTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  const bool isIntegral = features.Has(OpticsFeature::Integral);
  if (isIntegral != ReplacesIntegral(scene))
  {
    return;
  }
  features.Add(OpticsFeature::EmptySpace);
  if (isIntegral)
  {
    features.Add(OpticsFeature::EmptySpaceOfSegments);
  }
  else
  {
    features.Add(OpticsFeature::EmptySpaceOfSamples);
    features.Add(OpticsFeature::RayEnd);
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
