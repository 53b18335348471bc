// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAmbientCovarianceFilter.h"

#include "ParameterRange.h"

#include "Batches.h"
#include "CovarianceField.h"
#include "ProcessGroup.h"
#include "RangeSearch.h"

#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkAmbientCovarianceFilter);

using volumeoptics::Extent;
using volumeoptics::ImageGrid;

namespace
{
const char* const SamplingPatternNames[] = { "Shared", "PerBlock", "PerVoxel", "Exhaustive" };
const char* const SampleInterpolationNames[] = { "Nearest", "Linear" };

vtkDataArray* FindNormals(vtkImageData* image)
{
  vtkDataArray* named = image->GetPointData()->GetArray("Normals");
  vtkDataArray* normals = named ? named : image->GetPointData()->GetNormals();
  return normals && normals->GetNumberOfComponents() == 3 ? normals : nullptr;
}
}

//------------------------------------------------------------------------------
vtkAmbientCovarianceFilter::vtkAmbientCovarianceFilter()
  : Search(std::make_unique<volumeoptics::RangeSearch>())
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkAmbientCovarianceFilter::~vtkAmbientCovarianceFilter() = default;

//------------------------------------------------------------------------------
int vtkAmbientCovarianceFilter::FillInputPortInformation(int port, vtkInformation* information)
{
  if (port == 1)
  {
    information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, information);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetNormalsData(vtkImageData* normals)
{
  this->SetInputDataInternal(1, normals);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetRadius(double radius)
{
  volumeoptics::SetWithinRange(this, "Radius", radius, 0.5, 256.0, this->Radius);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetScalarTolerance(double tolerance)
{
  volumeoptics::SetWithinRange(this, "ScalarTolerance", tolerance, 0.0, 1.0, this->ScalarTolerance);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetScalarRange(double least, double largest)
{
  volumeoptics::SetFiniteRange(this, "ScalarRange", least, largest, this->ScalarRange);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetNumberOfSamples(int number)
{
  volumeoptics::SetWithinRange(this, "NumberOfSamples", number, 3, 65536, this->NumberOfSamples);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetSamplingPattern(int pattern)
{
  volumeoptics::SetChoice(this, "SamplingPattern", pattern, SamplingPatternNames, this->SamplingPattern);
}

//------------------------------------------------------------------------------
const char* vtkAmbientCovarianceFilter::GetSamplingPatternAsString()
{
  return SamplingPatternNames[this->SamplingPattern];
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetSampleInterpolation(int interpolation)
{
  volumeoptics::SetChoice(
    this, "SampleInterpolation", interpolation, SampleInterpolationNames, this->SampleInterpolation);
}

//------------------------------------------------------------------------------
const char* vtkAmbientCovarianceFilter::GetSampleInterpolationAsString()
{
  return SampleInterpolationNames[this->SampleInterpolation];
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetFilterStandardDeviation(double standardDeviation)
{
  volumeoptics::SetWithinRange(
    this, "FilterStandardDeviation", standardDeviation, 0.0, 100.0, this->FilterStandardDeviation);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetNoiseCorrection(bool correction)
{
  if (correction != this->NoiseCorrection)
  {
    this->NoiseCorrection = correction;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::GetReach(const ImageGrid& grid, int reach[3])
{
  const volumeoptics::Halo halo = volumeoptics::CovarianceField::GetReach(
    grid, this->Radius * grid.VoxelLength, this->FilterStandardDeviation * grid.VoxelLength);
  for (int axis = 0; axis < 3; ++axis)
  {
    reach[axis] = halo[axis] + 1; // the neighbours of a voxel without an estimate
  }
}

//------------------------------------------------------------------------------
int vtkAmbientCovarianceFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  if (IsComposite(inputs))
  {
    return 1;
  }
  const ImageGrid grid = this->GetGrid(inputs);
  if (this->Search->IsSearching())
  {
    const Extent slab = this->Search->GetSlab(grid.InputWhole);
    vtkInformation* input = inputs[0]->GetInformationObject(0);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), slab.data(), 6);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  if (inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    Extent extent;
    outputs->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
    volumeoptics::Halo halo =
      volumeoptics::CovarianceField::GetFilterReach(grid, this->FilterStandardDeviation * grid.VoxelLength);
    std::for_each(halo.begin(), halo.end(), [](int& voxels) { ++voxels; });
    extent = volumeoptics::IsEmpty(extent) ? extent : volumeoptics::Grown(extent, halo, grid.Whole);
    vtkInformation* normals = inputs[1]->GetInformationObject(0);
    normals->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data(), 6);
    // No fewer layers than the scalars' neighbourhood has: both inputs may come from one source, which keeps
    // one piece.
    normals->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      this->GetNumberOfInputPieces(outputs->GetInformationObject(0)) > 1
        ? this->GetGhostLevels(grid, outputs->GetInformationObject(0))
        : 0);
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkAmbientCovarianceFilter::FindRange(vtkInformationVector** inputs, vtkDataArray* scalars)
{
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetInputAlgorithm(0, 0)->GetExecutive());
  const volumeoptics::RangeSearch::Key key = { pipeline ? pipeline->GetPipelineMTime() : 0,
    scalars->GetName() ? scalars->GetName() : "", this->InputComponent };
  if (!this->Search->IsSearching() && this->Search->IsKnown(key))
  {
    return true;
  }
  const Extent whole = this->GetGrid(inputs).InputWhole;
  const volumeoptics::ImageRows rows(vtkImageData::GetData(inputs[0]), scalars, this->InputComponent);
  const bool isSlab = this->Search->IsSearching();
  const bool isWhole = !isSlab && volumeoptics::Contains(rows.GetBox(), whole);
  if (!isSlab)
  {
    this->Search->Start(whole, rows.GetBox());
  }
  volumeoptics::Batches batches(this);
  if ((isSlab || isWhole) && !this->Search->Add(batches, rows))
  {
    this->Search->Stop();
    return true; // aborted
  }
  if (isWhole || (isSlab && !this->Search->Next(whole)))
  {
    this->Search->Finish(key);
  }
  return isWhole;
}

//------------------------------------------------------------------------------
int vtkAmbientCovarianceFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  const volumeoptics::ProcessGroup processes = this->GetProcesses(outputs->GetInformationObject(0));
  this->IsShared = processes.IsShared();
  if (this->IsShared && !this->HasScalarRange())
  {
    this->FindScalarRange(processes, inputs, this->RangeOfProcesses);
  }
  vtkDataArray* scalars = this->FindScalars(inputs);
  if (scalars && !this->IsShared && !this->HasScalarRange() && !this->FindRange(inputs, scalars))
  {
    // Once more, for the next slab or, with the range known, for the piece.
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }
  this->Search->Stop();
  return this->Superclass::RequestData(request, inputs, outputs);
}

//------------------------------------------------------------------------------
bool vtkAmbientCovarianceFilter::ComputeCodes(const ImageGrid& grid, const volumeoptics::ImageRows& rows,
  vtkInformationVector** inputs, volumeoptics::Batches& batches, volumeoptics::VoxelBox<float>& codes)
{
  std::unique_ptr<volumeoptics::NormalSource> normals;
  if (vtkImageData* image = vtkImageData::GetData(inputs[1]))
  {
    Extent whole;
    inputs[1]->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole.data());
    vtkDataArray* array = FindNormals(image);
    if (!array || whole != this->GetGrid(inputs).Whole)
    {
      vtkErrorMacro(
        << "The second input "
        << (array ? "has another extent than the output"
                  : "has no point array of 3 components called Normals")
        << ". Give it the output of vtkSobelNormalFilter with the same ResolutionFactor, or none.");
      return false;
    }
    normals = std::make_unique<volumeoptics::NormalSource>(image, array);
    const volumeoptics::Halo halo =
      volumeoptics::CovarianceField::GetFilterReach(grid, this->FilterStandardDeviation * grid.VoxelLength);
    if (!volumeoptics::Contains(normals->GetBox(), volumeoptics::Grown(codes.GetBox(), halo, grid.Whole)))
    {
      vtkErrorMacro("The normals of the second input do not reach as far as was requested of them. Give it "
                    "the output of vtkSobelNormalFilter, or none.");
      return false;
    }
  }
  const double unit = grid.VoxelLength;
  const double* found = this->IsShared ? this->RangeOfProcesses : this->Search->GetRange();
  const double* range = this->HasScalarRange() ? this->ScalarRange : found;
  const volumeoptics::CovarianceFieldSettings settings = {
    { this->Radius * unit, this->ScalarTolerance, this->NumberOfSamples,
      static_cast<volumeoptics::Sampling>(this->SamplingPattern), this->SampleInterpolation == Linear,
      this->Seed },
    { range[0], range[1] }, this->FilterStandardDeviation * unit, this->NoiseCorrection,
    static_cast<volumeoptics::Storage>(this->Storage)
  };
  const volumeoptics::ScalarSource source(grid, rows, this->Smoothing * unit);
  volumeoptics::CovarianceField field(grid, source, normals.get(), settings);
  return field.Compute(batches, codes);
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "ScalarTolerance: " << this->ScalarTolerance << "\n";
  os << indent << "ScalarRange: ";
  if (this->HasScalarRange())
  {
    os << this->ScalarRange[0] << ", " << this->ScalarRange[1] << "\n";
  }
  else
  {
    os << "of the whole extent\n";
  }
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "SamplingPattern: " << this->GetSamplingPatternAsString() << "\n";
  os << indent << "SampleInterpolation: " << this->GetSampleInterpolationAsString() << "\n";
  os << indent << "FilterStandardDeviation: " << this->FilterStandardDeviation << "\n";
  os << indent << "NoiseCorrection: " << (this->NoiseCorrection ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
