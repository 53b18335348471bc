// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeMapper.h"

#include "DefaultOptics.h"
#include "LightUniforms.h"
#include "OpticsFactory.h"
#include "OpticsTerms.h"
#include "SceneNeeds.h"
#include "SweepViews.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeTexture.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkOpticsVolumeMapper);

namespace
{
const double SlowestInteraction = 1.0; // frames a second, vtkSmartVolumeMapper's limit
}

//------------------------------------------------------------------------------
vtkOpticsVolumeMapper::vtkOpticsVolumeMapper()
  : Terms(new Implementation)
{
}

//------------------------------------------------------------------------------
vtkOpticsVolumeMapper::~vtkOpticsVolumeMapper() = default;

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::GPURender(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Terms->LeaveOtherWindow(this, renderer->GetRenderWindow());
  renderer->GetRenderWindow()->MakeCurrent();
  this->UpdateCoarseness(renderer, volume);
  this->UpdateSampleDistance();
  const LightLimit limit(renderer);
  if (limit.GetNumberOfLightsLeftOut() > 0)
  {
    this->Say("The renderer has more lights than the " + std::to_string(LightLimit::Largest) +
      " that this VTK's volume shader holds: the last ones are left out.");
  }
  OpticsScene scene = MakeOpticsScene(this, renderer, volume);
  scene.Optics = scene.Optics ? scene.Optics : this->Terms->PlainOptics.Get();
  const bool hasLines = scene.Scalars && HasLineVoxels(scene);
  const std::vector<OpticsTerm*> active = this->Terms->Prepare(scene);
  if (active.empty() && hasLines)
  {
    return; // a picture of the bricks' numbers would mean nothing
  }
  if (active.empty())
  {
    this->Draw(renderer, volume, false);
    return;
  }
  // before the first frame it is not known whether there are any
  const bool mayHaveBlocks = this->AssembledInputs.count(0) == 0 || this->HasPartitions();
  if (mayHaveBlocks && this->Terms->Sweeps(scene, active))
  {
    const auto draw = [this, renderer, volume]() { this->Superclass::GPURender(renderer, volume); };
    this->Terms->FillBlocks(scene, active, [&]() { this->DrawBySteps(renderer, volume, hasLines, draw); });
  }
  this->Terms->Pass->Attach(scene, active);
  this->Draw(renderer, volume, hasLines);
  this->Terms->Pass->Detach();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::Draw(vtkRenderer* renderer, vtkVolume* volume, bool hasLines)
{
  this->DrawBySteps(renderer, volume, hasLines, [&]() { this->DrawInParts(renderer, volume); });
}

//------------------------------------------------------------------------------
// VTK would take its sample distance from the bricks of lines, which are the image's cells; and it would adjust it
// again for each part of a frame that can be given up.
void vtkOpticsVolumeMapper::DrawBySteps(
  vtkRenderer* renderer, vtkVolume* volume, bool hasLines, const std::function<void()>& draw)
{
  const bool isAdjustedOnce = CanFrameBeAborted(renderer->GetRenderWindow()) &&
    this->AutoAdjustSampleDistances && vtkImageData::SafeDownCast(this->GetDataSetInput());
  if (!hasLines && !isAdjustedOnce)
  {
    draw();
    return;
  }
  this->ComputeReductionFactor(volume->GetAllocatedRenderTime());
  const double reduction = this->ReductionFactor;
  const auto distance = static_cast<float>(this->GetFrameSampleDistance(volume));
  const vtkTypeBool isAdjusted = this->AutoAdjustSampleDistances;
  const vtkTypeBool isLocked = this->LockSampleDistanceToInputSpacing;
  const float own = this->SampleDistance;
  this->AutoAdjustSampleDistances = 0;
  this->LockSampleDistanceToInputSpacing = 0;
  this->SampleDistance = distance;
  draw();
  this->AutoAdjustSampleDistances = isAdjusted;
  this->LockSampleDistanceToInputSpacing = isLocked;
  this->SampleDistance = own;
  this->ReductionFactor = reduction;
}

//------------------------------------------------------------------------------
// So that a frame can be given up while it is drawn. Where VTK draws on a target of its own, and where it would load
// the volume's blocks again for each part, it is one part.
void vtkOpticsVolumeMapper::DrawInParts(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!CanFrameBeAborted(window))
  {
    this->Superclass::GPURender(renderer, volume);
    return;
  }
  this->Terms->Scissor = std::make_unique<ScissorScope>(window);
  const bool isOnePart = this->ImageSampleDistance != 1.0F || this->AutoAdjustSampleDistances ||
    this->RenderToImage || this->UseDepthPass || renderer->GetSelector() || this->HasPartitions();
  const auto tiles =
    isOnePart ? std::vector<ScissorScope::Rectangle>() : this->Terms->Scissor->Tiles(renderer, volume);
  if (isOnePart)
  {
    this->Superclass::GPURender(renderer, volume);
  }
  for (std::size_t i = 0; i < tiles.size() && !IsFrameAborted(window); ++i)
  {
    this->Terms->Scissor->Restrict(tiles[i]);
    this->Superclass::GPURender(renderer, volume);
  }
  this->Terms->Scissor.reset();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  const std::string missing = this->FindMissing();
  if (missing.empty())
  {
    const double times[2] = { this->BigTimeToDraw, this->SmallTimeToDraw };
    this->Superclass::Render(renderer, volume);
    if (renderer->GetRenderWindow()->GetAbortRender())
    {
      this->BigTimeToDraw = times[0]; // a part of a frame says nothing of the whole
      this->SmallTimeToDraw = times[1];
    }
  }
  else if (this->Terms->Said.insert(missing).second)
  {
    vtkErrorMacro(<< missing);
  }
}

//------------------------------------------------------------------------------
std::string vtkOpticsVolumeMapper::FindMissing()
{
  if (this->GetInputCount() > 1 || this->GetNumberOfInputConnections(0) == 0)
  {
    return std::string(); // VTK looks at each of several volumes, and says itself that there is none
  }
  this->Update();
  int cellFlag = 0;
  vtkDataArray* scalars = GetScalars(this->GetDataSetInput(), this->GetScalarMode(),
    this->GetArrayAccessMode(), this->GetArrayId(), this->GetArrayName(), cellFlag);
  if (scalars && scalars->GetNumberOfTuples() > 0)
  {
    return std::string();
  }
  const char* name = this->GetArrayName();
  return "The volume has no scalars to draw" +
    (name && *name ? " (array \"" + std::string(name) + "\")" : "") +
    ". Give its points or cells scalars, or name one of its arrays by SelectScalarArray().";
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (OpticsTerm* term : this->Terms->All)
  {
    term->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
// Of the finer ones, where a block replaces lines.
void vtkOpticsVolumeMapper::GetVoxelSpacing(double spacing[3])
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  volumeoptics::GetVoxelSpacing(image, spacing);
  vtkImageData* block = volumeoptics::HoldsLineVoxels(image) ? this->GetLineBlock() : nullptr;
  double ofBlock[3] = { spacing[0], spacing[1], spacing[2] };
  if (block)
  {
    volumeoptics::GetVoxelSpacing(block, ofBlock);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = std::min(std::abs(spacing[axis]), std::abs(ofBlock[axis]));
  }
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::Say(const std::string& message)
{
  if (this->Terms->Said.insert(message).second)
  {
    vtkWarningMacro(<< message);
  }
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::IsInteractive(vtkRenderer* renderer)
{
  vtkRenderWindowInteractor* interactor = renderer->GetRenderWindow()->GetInteractor();
  const double rate = renderer->GetRenderWindow()->GetDesiredUpdateRate();
  if (!interactor || !interactor->GetInteractorStyle())
  {
    return !interactor && rate >= SlowestInteraction;
  }
  // still frames of ParaView have a rate of their own, above the interactor's
  return rate > interactor->GetStillUpdateRate() &&
    rate >= std::min(interactor->GetDesiredUpdateRate(), SlowestInteraction);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::GetLoadedScalarRange(int component, double range[2])
{
  const auto& loaded = this->AssembledInputs[0].Texture->ScalarRange[component];
  range[0] = loaded[0];
  range[1] = loaded[1];
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::HasPartitions()
{
  const auto input = this->AssembledInputs.find(0);
  if (input == this->AssembledInputs.end() || !input->second.Texture)
  {
    return false;
  }
  const auto& partitions = input->second.Texture->GetPartitions();
  return partitions[0] > 1 || partitions[1] > 1 || partitions[2] > 1;
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeMapper::GetNumberOfBlocks()
{
  const auto& parts = this->AssembledInputs[0].Texture->GetPartitions();
  return parts[0] * parts[1] * parts[2];
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkOpticsVolumeMapper::GetVolumeTexture()
{
  return this->AssembledInputs[0].Texture->GetCurrentBlock()->TextureObject;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::GetTextureToData(double matrix[16])
{
  vtkVolumeTexture* texture = this->AssembledInputs[0].Texture;
  double pointToCell[16];
  vtkMatrix4x4::Invert(texture->CellToPointMatrix->GetData(), pointToCell);
  vtkMatrix4x4::Multiply4x4(texture->GetCurrentBlock()->TextureToDataset->GetData(), pointToCell, matrix);
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::FindVisibleBox(double box[6])
{
  float least[3], greatest[3];
  this->GetTextureBox(least, greatest);
  const bool isKnown = this->Terms->EmptySpace.FindVisibleBox(box);
  for (int axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] = std::max<double>(box[2 * axis], least[axis]);
    box[2 * axis + 1] = std::min<double>(box[2 * axis + 1], greatest[axis]);
  }
  return isKnown;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::GetTextureBox(float least[3], float greatest[3])
{
  vtkVolumeTexture* texture = this->AssembledInputs[0].Texture;
  std::copy_n(texture->AdjustedTexMin, 3, least);
  std::copy_n(texture->AdjustedTexMax, 3, greatest);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::GetAverageIPScalarRange(double range[2])
{
  this->Superclass::GetAverageIPScalarRange(range);
  this->Terms->Pass->BeforeDraw();
  if (this->Terms->Scissor && IsFrameAborted(this->Terms->LastWindow))
  {
    this->Terms->Scissor->Restrict({ 0, 0, 0, 0 }); // neither this block nor those after it
  }
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetGlobalOverride(bool enabled)
{
  OpticsFactory::SetEnabled("vtkGPUVolumeRayCastMapper", enabled);
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::GetGlobalOverride()
{
  return OpticsFactory::GetEnabled("vtkGPUVolumeRayCastMapper");
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetDefaultOptics(vtkOpticsVolumeProperty* property)
{
  DefaultOptics::Set(property);
}

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty* vtkOpticsVolumeMapper::GetDefaultOptics()
{
  return DefaultOptics::Get();
}
