// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAmbientCovarianceFilter.h"

#include "Batches.h"
#include "CovarianceField.h"

#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
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

// Range of a box's values; (1, 0) if it has none.
void ExtendRange(const volumeoptics::ImageRows& rows, const Extent& box, double range[2])
{
  std::vector<double> values(box[1] - box[0] + 1);
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      rows.Read(box[0], box[1], y, z, values.data());
      for (const double value : values)
      {
        if (!std::isnan(value))
        {
          const bool isFirst = range[0] > range[1];
          range[0] = isFirst ? value : std::min(range[0], value);
          range[1] = isFirst ? value : std::max(range[1], value);
        }
      }
    }
  }
}
}

//------------------------------------------------------------------------------
vtkAmbientCovarianceFilter::vtkAmbientCovarianceFilter()
{
  this->SetNumberOfInputPorts(2);
}

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
  const double value = this->WithinRange("Radius", radius, 0.5, 256.0, this->Radius);
  if (value != this->Radius)
  {
    this->Radius = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetScalarTolerance(double tolerance)
{
  const double value =
    this->WithinRange("ScalarTolerance", tolerance, 0.0, 1.0, this->ScalarTolerance);
  if (value != this->ScalarTolerance)
  {
    this->ScalarTolerance = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetScalarRange(double least, double largest)
{
  if (!std::isfinite(least) || !std::isfinite(largest))
  {
    vtkWarningMacro(<< "ScalarRange " << least << ", " << largest << " is not finite; it stays "
                    << this->ScalarRange[0] << ", " << this->ScalarRange[1] << ".");
    return;
  }
  if (least != this->ScalarRange[0] || largest != this->ScalarRange[1])
  {
    this->ScalarRange[0] = least;
    this->ScalarRange[1] = largest;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetNumberOfSamples(int number)
{
  const int value = static_cast<int>(
    this->WithinRange("NumberOfSamples", number, 3, 65536, this->NumberOfSamples));
  if (value != this->NumberOfSamples)
  {
    this->NumberOfSamples = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetSamplingPattern(int pattern)
{
  if (pattern < Shared || pattern > Exhaustive)
  {
    vtkWarningMacro(<< "SamplingPattern " << pattern
                    << " is none of Shared (0), PerBlock (1), PerVoxel (2), Exhaustive (3); it stays "
                    << this->GetSamplingPatternAsString() << ".");
    return;
  }
  if (pattern != this->SamplingPattern)
  {
    this->SamplingPattern = pattern;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkAmbientCovarianceFilter::GetSamplingPatternAsString()
{
  return SamplingPatternNames[this->SamplingPattern];
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetSampleInterpolation(int interpolation)
{
  if (interpolation != Nearest && interpolation != Linear)
  {
    vtkWarningMacro(<< "SampleInterpolation " << interpolation
                    << " is none of Nearest (0), Linear (1); it stays "
                    << this->GetSampleInterpolationAsString() << ".");
    return;
  }
  if (interpolation != this->SampleInterpolation)
  {
    this->SampleInterpolation = interpolation;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkAmbientCovarianceFilter::GetSampleInterpolationAsString()
{
  return SampleInterpolationNames[this->SampleInterpolation];
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::SetFilterStandardDeviation(double standardDeviation)
{
  const double value = this->WithinRange(
    "FilterStandardDeviation", standardDeviation, 0.0, 100.0, this->FilterStandardDeviation);
  if (value != this->FilterStandardDeviation)
  {
    this->FilterStandardDeviation = value;
    this->Modified();
  }
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
  const ImageGrid grid = this->GetGrid(inputs);
  if (this->RangeSlab >= 0)
  {
    int slab[6];
    this->GetRangeSlab(grid.InputWhole.data(), slab);
    inputs[0]->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), slab, 6);
  }
  if (inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    Extent extent;
    outputs->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
    volumeoptics::Halo halo = volumeoptics::CovarianceField::GetFilterReach(
      grid, this->FilterStandardDeviation * grid.VoxelLength);
    std::for_each(halo.begin(), halo.end(), [](int& voxels) { ++voxels; });
    extent = volumeoptics::IsEmpty(extent) ? extent : volumeoptics::Grown(extent, halo, grid.Whole);
    inputs[1]->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data(), 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkAmbientCovarianceFilter::GetRangeSlab(const int whole[6], int slab[6]) const
{
  std::copy(whole, whole + 6, slab);
  slab[4] = whole[4] + this->RangeSlab * this->RangeSlabSize;
  slab[5] = std::min(slab[4] + this->RangeSlabSize - 1, whole[5]);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAmbientCovarianceFilter::GetInputTime()
{
  auto* pipeline =
    vtkDemandDrivenPipeline::SafeDownCast(this->GetInputAlgorithm(0, 0)->GetExecutive());
  return pipeline ? pipeline->GetPipelineMTime() : 0;
}

//------------------------------------------------------------------------------
bool vtkAmbientCovarianceFilter::AddToRange(vtkInformationVector** inputs)
{
  vtkDataArray* scalars = this->GetScalars(inputs);
  if (!scalars)
  {
    return false;
  }
  const volumeoptics::ImageRows rows(
    vtkImageData::GetData(inputs[0]), scalars, this->InputComponent);
  const auto tiles = volumeoptics::SplitIntoTiles(rows.GetBox(), 32, 1.0e6);
  std::vector<std::array<double, 2>> ranges(tiles.size(), { 1.0, 0.0 });
  volumeoptics::Batches batches(this);
  const bool isComplete = batches.Run(tiles.size(), 0.0,
    [&](long long unit) { ExtendRange(rows, tiles[unit], ranges[unit].data()); });
  for (const auto& range : ranges)
  {
    if (range[0] <= range[1])
    {
      const bool isFirst = this->FoundRange[0] > this->FoundRange[1];
      this->FoundRange[0] = isFirst ? range[0] : std::min(this->FoundRange[0], range[0]);
      this->FoundRange[1] = isFirst ? range[1] : std::max(this->FoundRange[1], range[1]);
    }
  }
  return isComplete;
}

//------------------------------------------------------------------------------
// True if the filter must be executed again, with another extent of the input.
bool vtkAmbientCovarianceFilter::NeedsRangePass(
  vtkInformation* request, vtkInformationVector** inputs)
{
  const ImageGrid grid = this->GetGrid(inputs);
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputs);
  const std::string name = scalars && scalars->GetName() ? scalars->GetName() : "";
  const bool isKnown = this->RangeSlab < 0 && this->FoundRangeTime == this->GetInputTime() &&
    this->FoundRangeName == name && this->FoundRangeComponent == this->InputComponent;
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  if (this->HasScalarRange() || isKnown || !scalars)
  {
    this->RangeSlab = -1;
    return false;
  }
  Extent box;
  input->GetExtent(box.data());
  const bool hasWhole = this->RangeSlab < 0 && volumeoptics::Contains(box, grid.InputWhole);
  if (this->RangeSlab < 0)
  {
    this->FoundRange[0] = 1.0;
    this->FoundRange[1] = 0.0;
    const Extent slice = { grid.InputWhole[0], grid.InputWhole[1], grid.InputWhole[2],
      grid.InputWhole[3], 0, 0 };
    const long long slices = volumeoptics::NumberOfVoxels(box) / volumeoptics::NumberOfVoxels(slice);
    this->RangeSlabSize = static_cast<int>(std::max(slices, 1LL));
  }
  if ((hasWhole || this->RangeSlab >= 0) && !this->AddToRange(inputs))
  {
    this->RangeSlab = -1;
    return false;
  }
  const int slices = grid.InputWhole[5] - grid.InputWhole[4] + 1;
  ++this->RangeSlab;
  const bool isComplete = hasWhole || this->RangeSlab * this->RangeSlabSize >= slices;
  if (isComplete)
  {
    this->RangeSlab = -1;
    this->FoundRangeTime = this->GetInputTime();
    this->FoundRangeName = name;
    this->FoundRangeComponent = this->InputComponent;
  }
  if (!hasWhole)
  {
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
  }
  return !hasWhole;
}

//------------------------------------------------------------------------------
int vtkAmbientCovarianceFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return this->NeedsRangePass(request, inputs)
    ? 1
    : this->Superclass::RequestData(request, inputs, outputs);
}

//------------------------------------------------------------------------------
bool vtkAmbientCovarianceFilter::ComputeCodes(const ImageGrid& grid,
  const volumeoptics::ImageRows& rows, vtkInformationVector** inputs,
  volumeoptics::Batches& batches, volumeoptics::VoxelBox<float>& codes)
{
  std::unique_ptr<volumeoptics::NormalSource> normals;
  if (vtkImageData* image = vtkImageData::GetData(inputs[1]))
  {
    Extent whole;
    inputs[1]->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole.data());
    vtkDataArray* array = FindNormals(image);
    if (!array || whole != grid.Whole)
    {
      vtkErrorMacro(<< "The second input " << (array ? "has another extent than the output"
                                                     : "has no point array of 3 components called Normals")
                    << ". Give it the output of vtkSobelNormalFilter with the same ResolutionFactor, or none.");
      return false;
    }
    normals = std::make_unique<volumeoptics::NormalSource>(image, array);
  }
  const double unit = grid.VoxelLength;
  const double* range = this->HasScalarRange() ? this->ScalarRange : this->FoundRange;
  const volumeoptics::CovarianceFieldSettings settings = {
    { this->Radius * unit, this->ScalarTolerance, this->NumberOfSamples,
      static_cast<volumeoptics::Sampling>(this->SamplingPattern),
      this->SampleInterpolation == Linear, this->Seed },
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
