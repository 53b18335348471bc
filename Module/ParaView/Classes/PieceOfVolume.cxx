// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceOfVolume.h"

#include "OwnedExtent.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
const char* const OwnedExtentName = "vtkOpticsOwnedExtent";

bool IsEmpty(const int extent[6])
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

// As vtkVolumeMapper::SpacingAdjustedSampleDistance(), which is protected.
struct VTKSampleDistance : vtkOpticsVolumeMapper
{
  static double Find(vtkOpticsVolumeMapper* mapper, double spacing[3], int extent[6])
  {
    return (mapper->*(&VTKSampleDistance::SpacingAdjustedSampleDistance))(spacing, extent);
  }
};

// Of an image or a rectilinear grid.
vtkSmartPointer<vtkDataSet> WithoutGhostLayers(vtkDataSet* block)
{
  vtkNew<vtkImageData> indices;
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(block))
  {
    indices->SetExtent(grid->GetExtent());
  }
  else
  {
    indices->SetExtent(vtkImageData::SafeDownCast(block)->GetExtent());
  }
  indices->GetCellData()->AddArray(block->GetCellGhostArray());
  auto owned = vtk::TakeSmartPointer(block->NewInstance());
  owned->ShallowCopy(block);
  owned->Crop(volumeoptics::OwnedExtent(indices).data());
  return owned;
}

// Of the marks of ghosts those that hide, so that VTK does not leave out what belongs to others.
void KeepHidden(vtkDataSetAttributes* attributes)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(name));
  if (!ghosts)
  {
    return;
  }
  const unsigned char hidden = attributes->IsA("vtkPointData")
    ? static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT)
    : static_cast<unsigned char>(vtkDataSetAttributes::HIDDENCELL);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->DeepCopy(ghosts);
  bool hasHidden = false;
  for (vtkIdType i = 0; i < marks->GetNumberOfValues(); ++i)
  {
    marks->SetValue(i, marks->GetValue(i) & hidden);
    hasHidden = hasHidden || marks->GetValue(i) != 0;
  }
  attributes->RemoveArray(name);
  if (hasHidden)
  {
    attributes->AddArray(marks);
  }
}

// The distance of samples that VTK takes for the whole extent; its own follows the piece's.
void TakeSampleDistanceOf(const int wholeExtent[6], vtkImageData* piece, vtkOpticsVolumeMapper* mapper)
{
  if (IsEmpty(wholeExtent) || !mapper->GetLockSampleDistanceToInputSpacing())
  {
    return;
  }
  double spacing[3];
  piece->GetSpacing(spacing);
  int extent[6];
  std::copy(wholeExtent, wholeExtent + 6, extent);
  mapper->LockSampleDistanceToInputSpacingOff();
  mapper->SetSampleDistance(static_cast<float>(VTKSampleDistance::Find(mapper, spacing, extent)));
}
}

//------------------------------------------------------------------------------
bool DrawsPieces()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> KeepGhostLayers(vtkImageData* image)
{
  auto piece = vtk::TakeSmartPointer(image->NewInstance());
  piece->ShallowCopy(image);
  vtkNew<vtkIntArray> extent;
  extent->SetName(OwnedExtentName);
  extent->SetNumberOfValues(6);
  const volumeoptics::Extent owned = volumeoptics::OwnedExtent(image);
  std::copy(owned.begin(), owned.end(), extent->GetPointer(0));
  piece->GetFieldData()->AddArray(extent);
  KeepHidden(piece->GetPointData());
  KeepHidden(piece->GetCellData());
  return piece;
}

//------------------------------------------------------------------------------
vtkBoundingBox KeepGhostLayersOfBlocks(vtkPartitionedDataSet* blocks)
{
  vtkBoundingBox bounds;
  for (unsigned int i = 0; i < blocks->GetNumberOfPartitions(); ++i)
  {
    vtkDataSet* block = blocks->GetPartition(i);
    vtkSmartPointer<vtkDataSet> drawn = block;
    if (block && block->HasAnyGhostCells())
    {
      drawn = WithoutGhostLayers(block);
      auto* image = vtkImageData::SafeDownCast(block);
      blocks->SetPartition(i, image ? KeepGhostLayers(image).Get() : drawn.Get());
    }
    if (drawn && drawn->GetNumberOfPoints() > 0)
    {
      bounds.AddBounds(drawn->GetBounds());
    }
  }
  return bounds;
}

//------------------------------------------------------------------------------
void DrawAsPiece(vtkImageData* piece, const int wholeExtent[6], vtkOpticsVolumeMapper* mapper)
{
  auto* owned = vtkIntArray::SafeDownCast(piece->GetFieldData()->GetArray(OwnedExtentName));
  mapper->SetDrawnExtent(owned ? owned->GetPointer(0) : piece->GetExtent());
  mapper->SetWholeExtent(wholeExtent);
  TakeSampleDistanceOf(wholeExtent, piece, mapper);
}
