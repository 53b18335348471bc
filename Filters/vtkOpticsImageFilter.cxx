// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsImageFilter.h"

#include "ParameterRange.h"

#include "Batches.h"
#include "GaussianFilter.h"
#include "PieceExtent.h"
#include "ScalarSource.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <string>

using volumeoptics::Extent;
using volumeoptics::ImageGrid;

namespace
{
void SetGeometry(const ImageGrid& grid, vtkInformation* input, vtkInformation* output)
{
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), grid.Whole.data(), 6);
  output->Set(vtkDataObject::SPACING(), &grid.Spacing.x, 3);
  if (input->Has(vtkDataObject::ORIGIN()))
  {
    output->CopyEntry(input, vtkDataObject::ORIGIN());
  }
  if (input->Has(vtkDataObject::DIRECTION()))
  {
    output->CopyEntry(input, vtkDataObject::DIRECTION());
  }
}

// Those of the same grid, cut out of what the filter needed around them.
void PassArrays(vtkImageData* input, vtkImageData* output)
{
  vtkNew<vtkImageData> part;
  part->ShallowCopy(input);
  part->Crop(output->GetExtent());
  vtkPointData* arrays = part->GetPointData();
  for (int array = 0; array < arrays->GetNumberOfArrays(); ++array)
  {
    const std::string name = arrays->GetArrayName(array) ? arrays->GetArrayName(array) : "";
    const bool isNew = !name.empty() && !output->GetPointData()->HasArray(name.c_str());
    if (isNew && name != vtkDataSetAttributes::GhostArrayName())
    {
      output->GetPointData()->AddArray(arrays->GetAbstractArray(array));
    }
  }
  if (arrays->GetScalars() && arrays->GetScalars()->GetName())
  {
    output->GetPointData()->SetActiveScalars(arrays->GetScalars()->GetName());
  }
}
}

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::SetResolutionFactor(double factor)
{
  volumeoptics::SetWithinRange(this, "ResolutionFactor", factor, 0.01, 1.0, this->ResolutionFactor);
}

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::SetSmoothing(double standardDeviation)
{
  volumeoptics::SetWithinRange(this, "Smoothing", standardDeviation, 0.0, 100.0, this->Smoothing);
}

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::SetInputComponent(int component)
{
  volumeoptics::SetWithinRange(this, "InputComponent", component, 0, VTK_INT_MAX, this->InputComponent);
}

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::SetOutputPrecision(int bits)
{
  volumeoptics::SetPrecision(this, "OutputPrecision", bits, this->OutputPrecision);
}

//------------------------------------------------------------------------------
ImageGrid vtkOpticsImageFilter::GetGrid(vtkInformationVector** inputs)
{
  return volumeoptics::MakeImageGrid(inputs[0]->GetInformationObject(0), this->ResolutionFactor);
}

//------------------------------------------------------------------------------
bool vtkOpticsImageFilter::HasExtent(vtkInformationVector** inputs)
{
  const bool hasExtent =
    inputs[0]->GetInformationObject(0)->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()) != 0;
  if (!hasExtent)
  {
    vtkErrorMacro("The input has no extent. Connect an image (vtkImageData).");
  }
  return hasExtent;
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!this->HasExtent(inputs))
  {
    return 0;
  }
  SetGeometry(this->GetGrid(inputs), inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::GetExtentToCompute(const ImageGrid&, vtkInformation* output, int extent[6])
{
  output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
}

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::GetNeededExtent(const ImageGrid& grid, const int output[6], int input[6])
{
  Extent extent;
  std::copy(output, output + 6, extent.data());
  if (!volumeoptics::IsEmpty(extent))
  {
    volumeoptics::Halo reach;
    this->GetReach(grid, reach.data());
    extent = volumeoptics::Grown(extent, reach, grid.Whole);
    if (this->Smoothing > 0.0)
    {
      const volumeoptics::GaussianFilter gaussian(grid, this->Smoothing * grid.VoxelLength);
      extent = volumeoptics::Grown(extent, gaussian.GetHalo(), grid.Whole);
    }
    extent = volumeoptics::InputExtent(grid, extent);
  }
  std::copy(extent.begin(), extent.end(), input);
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const ImageGrid grid = this->GetGrid(inputs);
  int extent[6];
  this->GetExtentToCompute(grid, outputs->GetInformationObject(0), extent);
  int input[6];
  this->GetNeededExtent(grid, extent, input);
  vtkInformation* information = inputs[0]->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), input, 6);
  vtkInformation* output = outputs->GetInformationObject(0);
  if (volumeoptics::IsPiece(output))
  {
    const int layers = output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
    information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      this->GetGhostLayers(grid, layers));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::GetGhostLayers(const ImageGrid& grid, int layersOfOutput)
{
  volumeoptics::Halo reach;
  this->GetReach(grid, reach.data());
  int largest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    int voxels = reach[axis];
    if (this->Smoothing > 0.0)
    {
      voxels += volumeoptics::GaussianFilter(grid, this->Smoothing * grid.VoxelLength).GetHalo()[axis];
    }
    largest = std::max(largest, voxels);
  }
  return volumeoptics::GhostLayersOfInput(grid, layersOfOutput, largest);
}

//------------------------------------------------------------------------------
// Of the extent to compute, what belongs to this piece of the input; of the grid, what there is of it, where
// that is less than what is needed.
void vtkOpticsImageFilter::LimitToPiece(
  vtkImageData* input, vtkInformation* output, ImageGrid& grid, int extent[6])
{
  const int layers = output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  Extent piece = volumeoptics::OutputExtent(grid, volumeoptics::OwnExtent(input));
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = std::max(extent[2 * axis], piece[2 * axis] - layers);
    extent[2 * axis + 1] = std::min(extent[2 * axis + 1], piece[2 * axis + 1] + layers);
  }
  Extent wanted;
  std::copy(extent, extent + 6, wanted.data());
  Extent needed;
  this->GetNeededExtent(grid, extent, needed.data());
  Extent held;
  input->GetExtent(held.data());
  if (volumeoptics::IsEmpty(piece) || volumeoptics::IsEmpty(wanted) || volumeoptics::Contains(held, needed))
  {
    return;
  }
  vtkWarningMacro(<< "A piece of the input has fewer than the " << this->GetGhostLayers(grid, layers)
                  << " layers of ghost cells that are needed: its borders count as the volume's. Give it ghost "
                     "cells, by vtkGhostCellsGenerator for example.");
  grid = volumeoptics::Restricted(grid, held);
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = std::max(extent[2 * axis], grid.Whole[2 * axis]);
    extent[2 * axis + 1] = std::min(extent[2 * axis + 1], grid.Whole[2 * axis + 1]);
  }
}

//------------------------------------------------------------------------------
vtkDataArray* vtkOpticsImageFilter::FindScalars(vtkInformationVector** inputs, int& association)
{
  association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputs, association);
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  if (!scalars && name && !*name)
  {
    association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    scalars = vtkImageData::GetData(inputs[0])->GetPointData()->GetScalars();
  }
  return scalars;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkOpticsImageFilter::GetScalars(vtkInformationVector** inputs)
{
  int association;
  vtkDataArray* scalars = this->FindScalars(inputs, association);
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    vtkErrorMacro("The input has no scalars to work on. Give it point scalars, or name an array by "
                  "SetInputArrayToProcess().");
    return nullptr;
  }
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    vtkErrorMacro("Array \"" << (scalars->GetName() ? scalars->GetName() : "")
                             << "\" is not of the points. Convert it first, for example by "
                                "vtkCellDataToPointData.");
    return nullptr;
  }
  if (this->InputComponent >= scalars->GetNumberOfComponents())
  {
    vtkErrorMacro(<< "InputComponent " << this->InputComponent << " is not one of the array's "
                  << scalars->GetNumberOfComponents() << " components. Set it to 0 to "
                  << scalars->GetNumberOfComponents() - 1 << ".");
    return nullptr;
  }
  return scalars;
}

//------------------------------------------------------------------------------
float* vtkOpticsImageFilter::AddArray(vtkImageData* output, const char* name, int components)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  output->GetPointData()->AddArray(array);
  return array->GetPointer(0);
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  ImageGrid grid = this->GetGrid(inputs);
  Extent extent;
  this->GetExtentToCompute(grid, outputs->GetInformationObject(0), extent.data());
  if (input && volumeoptics::IsPiece(outputs->GetInformationObject(0)))
  {
    this->LimitToPiece(input, outputs->GetInformationObject(0), grid, extent.data());
  }
  if (!input || volumeoptics::IsEmpty(extent))
  {
    return 1;
  }
  vtkDataArray* scalars = this->GetScalars(inputs);
  if (!scalars)
  {
    return 0;
  }
  Extent needed;
  this->GetNeededExtent(grid, extent.data(), needed.data());
  const volumeoptics::ImageRows rows(input, scalars, this->InputComponent);
  if (!volumeoptics::Contains(rows.GetBox(), needed))
  {
    vtkErrorMacro("The input is smaller than the extent that was requested of it. Update the "
                  "filter before it.");
    return 0;
  }
  output->SetExtent(extent.data());
  output->SetSpacing(&grid.Spacing.x);
  output->SetOrigin(input->GetOrigin());
  output->SetDirectionMatrix(input->GetDirectionMatrix());
  volumeoptics::Batches batches(this);
  if (!this->ComputeArrays(grid, rows, inputs, batches, output))
  {
    output->Initialize();
    return this->AbortExecute;
  }
  if (this->PassInputArrays && this->IsOnInputGrid())
  {
    PassArrays(input, output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ResolutionFactor: " << this->ResolutionFactor << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "InputComponent: " << this->InputComponent << "\n";
  os << indent << "OutputPrecision: " << this->OutputPrecision << "\n";
  os << indent << "PassInputArrays: " << (this->PassInputArrays ? "on" : "off") << "\n";
}
