// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsImageFilter.h"

#include "ParameterRange.h"

#include "Batches.h"
#include "GaussianFilter.h"
#include "OwnedExtent.h"
#include "ProcessGroup.h"
#include "ScalarSource.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <string>

using volumeoptics::Extent;
using volumeoptics::ImageGrid;
using SDDP = vtkStreamingDemandDrivenPipeline;

// What is computed of the volume at once.
struct vtkOpticsImageFilter::Part
{
  ImageGrid Grid; // the whole, or as much of it as the input has
  Extent Computed;
  Extent Owned; // without ghost layers
};

namespace
{
void SetGeometry(const ImageGrid& grid, vtkInformation* input, vtkInformation* output)
{
  output->Set(SDDP::WHOLE_EXTENT(), grid.Whole.data(), 6);
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
vtkOpticsImageFilter::vtkOpticsImageFilter()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkOpticsImageFilter::~vtkOpticsImageFilter() = default;

//------------------------------------------------------------------------------
void vtkOpticsImageFilter::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkOpticsImageFilter::GetController() const
{
  return this->Controller;
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
bool vtkOpticsImageFilter::IsComposite(vtkInformationVector** inputs)
{
  return vtkCompositeDataSet::GetData(inputs[0]) != nullptr;
}

//------------------------------------------------------------------------------
bool vtkOpticsImageFilter::HasExtent(vtkInformationVector** inputs)
{
  const bool hasExtent = inputs[0]->GetInformationObject(0)->Has(SDDP::WHOLE_EXTENT()) != 0;
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
  if (IsComposite(inputs))
  {
    return 1;
  }
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
  output->Get(SDDP::UPDATE_EXTENT(), extent);
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::GetNumberOfInputPieces(vtkInformation* output)
{
  return volumeoptics::NumberOfPieces(output);
}

//------------------------------------------------------------------------------
volumeoptics::ProcessGroup vtkOpticsImageFilter::GetProcesses(vtkInformation* output)
{
  return volumeoptics::ProcessGroup(this->Controller, this, output);
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
// Layers of the input around a piece: those of the output, the reach, and, where the output is coarser,
// the way to the output's next voxel.
int vtkOpticsImageFilter::CountGhostLayers(const ImageGrid& grid, int layersOfOutput)
{
  volumeoptics::Halo reach;
  this->GetReach(grid, reach.data());
  int layers = *std::max_element(reach.begin(), reach.end());
  if (this->Smoothing > 0.0)
  {
    const volumeoptics::GaussianFilter gaussian(grid, this->Smoothing * grid.VoxelLength);
    const volumeoptics::Halo halo = gaussian.GetHalo();
    layers += *std::max_element(halo.begin(), halo.end());
  }
  layers += layersOfOutput + (grid.Factor < 1.0 ? 2 : 0);
  return static_cast<int>(std::ceil(layers / grid.Factor));
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::GetGhostLevels(const ImageGrid& grid, vtkInformation* output)
{
  return this->CountGhostLayers(grid, output->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()));
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::GetGhostLayers(double resolutionFactor)
{
  const int size = 1 << 20; // more than any reach
  const Extent whole = { 0, size, 0, size, 0, size };
  const glm::dmat3 axes(1.0);
  const ImageGrid grid = { whole, whole, resolutionFactor, glm::dvec3(1.0 / resolutionFactor), axes, axes,
    1.0 };
  return this->CountGhostLayers(grid, 0);
}

//------------------------------------------------------------------------------
int vtkOpticsImageFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (IsComposite(inputs))
  {
    return 1;
  }
  const ImageGrid grid = this->GetGrid(inputs);
  int extent[6];
  this->GetExtentToCompute(grid, outputs->GetInformationObject(0), extent);
  int input[6];
  this->GetNeededExtent(grid, extent, input);
  vtkInformation* request = inputs[0]->GetInformationObject(0);
  request->Set(SDDP::UPDATE_EXTENT(), input, 6);
  if (this->GetNumberOfInputPieces(outputs->GetInformationObject(0)) > 1)
  {
    request->Set(
      SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), this->GetGhostLevels(grid, outputs->GetInformationObject(0)));
  }
  else
  {
    request->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
    request->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
    request->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkOpticsImageFilter::Part vtkOpticsImageFilter::GetPart(
  const ImageGrid& whole, vtkInformation* output, vtkImageData* input)
{
  Part part = { whole, {}, {} };
  this->GetExtentToCompute(whole, output, part.Computed.data());
  part.Owned = part.Computed;
  if (this->GetNumberOfInputPieces(output) < 2 || volumeoptics::IsEmpty(part.Computed))
  {
    return part;
  }
  const Extent requested = part.Computed;
  const Extent owned = volumeoptics::OwnedExtent(input);
  part.Owned = part.Computed = volumeoptics::IsEmpty(owned)
    ? owned
    : volumeoptics::Intersection(volumeoptics::OutputExtent(whole, owned), requested);
  if (volumeoptics::IsEmpty(part.Owned))
  {
    return part;
  }
  const int ghosts = output->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  part.Computed = volumeoptics::Grown(part.Owned, { ghosts, ghosts, ghosts }, requested);
  Extent needed, box;
  this->GetNeededExtent(whole, part.Computed.data(), needed.data());
  input->GetExtent(box.data());
  if (!volumeoptics::Contains(box, needed))
  {
    vtkWarningMacro("The input's piece has fewer ghost layers than the "
      << this->GetGhostLevels(whole, output)
      << " that are needed: at the borders between pieces the result differs from that of the whole. Put "
         "vtkGhostCellsGenerator with that many layers before this filter.");
    part.Grid = volumeoptics::ClippedGrid(whole, box);
    part.Owned = volumeoptics::Intersection(part.Owned, part.Grid.Whole);
    part.Computed = volumeoptics::Intersection(part.Computed, part.Grid.Whole);
  }
  return part;
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
  if (!input)
  {
    return 1;
  }
  Part part = this->GetPart(this->GetGrid(inputs), outputs->GetInformationObject(0), input);
  if (volumeoptics::IsEmpty(part.Computed))
  {
    return 1;
  }
  vtkDataArray* scalars = this->GetScalars(inputs);
  if (!scalars)
  {
    return 0;
  }
  const ImageGrid& grid = part.Grid;
  Extent needed;
  this->GetNeededExtent(grid, part.Computed.data(), needed.data());
  const volumeoptics::ImageRows rows(input, scalars, this->InputComponent);
  if (!volumeoptics::Contains(rows.GetBox(), needed))
  {
    vtkErrorMacro("The input is smaller than the extent that was requested of it. Update the "
                  "filter before it.");
    return 0;
  }
  output->SetExtent(part.Computed.data());
  output->SetSpacing(&grid.Spacing.x);
  output->SetOrigin(input->GetOrigin());
  output->SetDirectionMatrix(input->GetDirectionMatrix());
  volumeoptics::Batches batches(this);
  if (!this->ComputeArrays(grid, rows, inputs, batches, output))
  {
    output->Initialize();
    return this->AbortExecute;
  }
  if (this->GetNumberOfInputPieces(outputs->GetInformationObject(0)) > 1)
  {
    output->GenerateGhostArray(part.Owned.data());
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
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "ResolutionFactor: " << this->ResolutionFactor << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "InputComponent: " << this->InputComponent << "\n";
  os << indent << "OutputPrecision: " << this->OutputPrecision << "\n";
  os << indent << "PassInputArrays: " << (this->PassInputArrays ? "on" : "off") << "\n";
}
