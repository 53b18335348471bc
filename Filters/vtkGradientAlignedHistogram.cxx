// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGradientAlignedHistogram.h"

#include "Batches.h"
#include "GradientAlignedSampler.h"
#include "OwnedExtent.h"
#include "ParameterRange.h"
#include "ProcessGroup.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

using volumeoptics::Extent;
using volumeoptics::ImageGrid;

vtkStandardNewMacro(vtkGradientAlignedHistogram);

namespace
{
// A tile with its surroundings stays in a core's cache.
const int LargestTile = 16;
const double VoxelsOfTile = 1.0e5;

// Equal bins over a range.
struct Axis
{
  double Least;
  double Largest;
  int Bins;

  double Width() const { return this->Largest / this->Bins - this->Least / this->Bins; }

  bool Contains(double value) const { return value >= this->Least && value <= this->Largest; }

  // Of a value at or above the least.
  int Bin(double value) const
  {
    const double position = (value - this->Least) / this->Width();
    return static_cast<int>(std::min(position, this->Bins - 1.0));
  }
};

struct Counts
{
  std::vector<vtkIdType> Pairs;
  std::vector<vtkIdType> Gradients;
};

// Which points belong to another piece: ghosts, and those in the extent of a process of lower number, because
// neighbours share the points between them. Without other processes the marked ones.
class Owners
{
public:
  Owners(vtkImageData* image, const ImageGrid& grid, const std::vector<Extent>& pieces, int piece)
    : Image(image)
    , Ghosts(pieces.size() > 1 ? nullptr : image->GetPointGhostArray())
    , Factor(grid.Factor)
  {
    this->Own = pieces.size() > 1 ? volumeoptics::OutputExtent(grid, pieces[piece]) : grid.Whole;
    for (int other = 0; other < piece; ++other)
    {
      const Extent extent = volumeoptics::OutputExtent(grid, pieces[other]);
      if (!volumeoptics::IsEmpty(pieces[other]) &&
        !volumeoptics::IsEmpty(volumeoptics::Intersection(this->Own, extent)))
      {
        this->Others.push_back(extent);
      }
    }
  }

  bool IsForeign(int x, int y, int z) const
  {
    const auto contains = [=](const Extent& extent) {
      return volumeoptics::Contains(extent, { x, x, y, y, z, z });
    };
    if (!contains(this->Own) || std::any_of(this->Others.begin(), this->Others.end(), contains))
    {
      return true;
    }
    if (!this->Ghosts)
    {
      return false;
    }
    int index[3] = { this->InputIndex(0, x), this->InputIndex(1, y), this->InputIndex(2, z) };
    const vtkIdType point = this->Image->ComputePointId(index);
    return (this->Ghosts->GetValue(point) & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
  }

private:
  int InputIndex(int axis, int index) const
  {
    const int* extent = this->Image->GetExtent();
    const int nearest = static_cast<int>(std::lround(index / this->Factor));
    return std::clamp(nearest, extent[2 * axis], extent[2 * axis + 1]);
  }

  vtkImageData* Image;
  vtkUnsignedCharArray* Ghosts;
  double Factor;
  Extent Own;
  std::vector<Extent> Others;
};

void CountTile(const Extent& tile, volumeoptics::GradientAlignedSampler& sampler, const Axis& scalars,
  const Axis& gradients, const Owners& owners, Counts& counts)
{
  for (int z = tile[4]; z <= tile[5]; ++z)
  {
    for (int y = tile[2]; y <= tile[3]; ++y)
    {
      int x = tile[0];
      for (const volumeoptics::GradientAlignedSample& sample : sampler.Row(y, z))
      {
        // NaN is in no range
        if (scalars.Contains(sample.Center) && scalars.Contains(sample.Ahead) &&
          scalars.Contains(sample.Behind) && !owners.IsForeign(x, y, z))
        {
          ++counts.Pairs[scalars.Bin(sample.Ahead) + scalars.Bins * scalars.Bin(sample.Behind)];
          ++counts
              .Gradients[scalars.Bin(sample.Center) + scalars.Bins * gradients.Bin(sample.GradientMagnitude)];
        }
        ++x;
      }
    }
  }
}

void StoreImage(const std::vector<vtkIdType>& counts, const Axis& x, const Axis& y, vtkImageData* image)
{
  const double axes[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  image->Initialize();
  image->SetDirectionMatrix(axes); // not the volume's
  image->SetDimensions(x.Bins, y.Bins, 1);
  image->SetOrigin(x.Least + 0.5 * x.Width(), y.Least + 0.5 * y.Width(), 0.0);
  image->SetSpacing(x.Width(), y.Width(), 1.0);
  vtkNew<vtkDoubleArray> array;
  array->SetName("Counts");
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  std::copy(counts.begin(), counts.end(), array->GetPointer(0));
  image->GetPointData()->SetScalars(array);
}
}

// What lives while an update of all processes lasts.
struct vtkGradientAlignedHistogram::Run
{
  int Process;
  std::vector<Extent> Pieces; // of each process, its own points
  Axis Scalars, Gradients;
  Counts Sums;
};

//------------------------------------------------------------------------------
vtkGradientAlignedHistogram::vtkGradientAlignedHistogram()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkGradientAlignedHistogram::~vtkGradientAlignedHistogram() = default;

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::SetNumberOfBins(int number)
{
  volumeoptics::SetWithinRange(this, "NumberOfBins", number, 1, 4096, this->NumberOfBins);
}

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::SetScalarRange(double least, double largest)
{
  volumeoptics::SetFiniteRange(this, "ScalarRange", least, largest, this->ScalarRange);
}

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::SetStepLength(double length)
{
  volumeoptics::SetWithinRange(this, "StepLength", length, 0.01, 1000.0, this->StepLength);
}

//------------------------------------------------------------------------------
int vtkGradientAlignedHistogram::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!IsComposite(inputs) && !this->HasExtent(inputs))
  {
    return 0;
  }
  const int extent[6] = { 0, this->NumberOfBins - 1, 0, this->NumberOfBins - 1, 0, 0 };
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* output = outputs->GetInformationObject(port);
    output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    vtkDataObject::SetPointDataActiveScalarInfo(output, VTK_DOUBLE, 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGradientAlignedHistogram::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  if (IsComposite(inputs))
  {
    return 1;
  }
  // All of it, for the range: a coarser grid may end before.
  inputs[0]->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), this->GetGrid(inputs).InputWhole.data(), 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGradientAlignedHistogram::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData::GetData(outputs, 1)->Initialize();
  const volumeoptics::ProcessGroup processes = this->GetProcesses(outputs->GetInformationObject(0));
  if (!processes.Any(!volumeoptics::IsEmpty(this->GetGrid(inputs).Whole)))
  {
    return this->Superclass::RequestData(request, inputs, outputs);
  }
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  const Extent nothing = { 0, -1, 0, -1, 0, -1 };
  this->Current = std::make_unique<Run>();
  this->Current->Process = processes.GetRank();
  this->Current->Pieces =
    processes.Gather(input && processes.IsShared() ? volumeoptics::OwnedExtent(input) : nothing);
  const bool hasRange = this->FindRange(processes, inputs, *this->Current);
  const bool isRight = hasRange && this->Superclass::RequestData(request, inputs, outputs) != 0;
  const bool isJoined = this->Join(processes, isRight && !this->AbortExecute);
  if (isJoined && (this->ResultOnAllProcesses || processes.GetRank() == 0))
  {
    this->Store(outputs);
  }
  else
  {
    vtkImageData::GetData(outputs)->Initialize();
  }
  this->Current.reset();
  return isRight || this->AbortExecute;
}

//------------------------------------------------------------------------------
int vtkGradientAlignedHistogram::GetNumberOfInputPieces(vtkInformation* output)
{
  return this->GetProcesses(output).GetSize();
}

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::GetReach(const ImageGrid& grid, int reach[3])
{
  const volumeoptics::Halo halo =
    volumeoptics::GradientAlignedSampler::GetReach(grid, this->StepLength * grid.VoxelLength);
  std::copy(halo.begin(), halo.end(), reach);
}

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::GetExtentToCompute(const ImageGrid& grid, vtkInformation*, int extent[6])
{
  std::copy(grid.Whole.begin(), grid.Whole.end(), extent);
}

//------------------------------------------------------------------------------
// Of all processes; false on abort.
bool vtkGradientAlignedHistogram::FindRange(
  const volumeoptics::ProcessGroup& processes, vtkInformationVector** inputs, Run& run)
{
  double range[2] = { this->ScalarRange[0], this->ScalarRange[1] };
  const bool isSet = range[0] <= range[1];
  if (!isSet && !this->FindScalarRange(processes, inputs, range))
  {
    return false;
  }
  if (range[0] > range[1]) // nothing to count
  {
    range[0] = 0.0;
    range[1] = 1.0;
  }
  if (range[1] / this->NumberOfBins - range[0] / this->NumberOfBins < std::numeric_limits<double>::min())
  {
    // half a unit, or more where that is below the value's precision
    const double half = std::max(0.5, std::abs(range[0]) * 1.0e-6);
    range[0] -= half;
    range[1] += half;
  }
  const ImageGrid grid = this->GetGrid(inputs);
  double finest = volumeoptics::IsEmpty(grid.Whole) ? VTK_DOUBLE_MAX : grid.VoxelLength;
  processes.Least(&finest, 1);
  const double steepest = (range[1] / 2.0 - range[0] / 2.0) / finest;
  run.Scalars = { range[0], range[1], this->NumberOfBins };
  run.Gradients = { 0.0, steepest, this->NumberOfBins };
  run.Sums.Pairs.resize(static_cast<std::size_t>(this->NumberOfBins) * this->NumberOfBins);
  run.Sums.Gradients.resize(run.Sums.Pairs.size());
  return true;
}

//------------------------------------------------------------------------------
bool vtkGradientAlignedHistogram::ComputeArrays(const ImageGrid& grid, const volumeoptics::ImageRows& rows,
  vtkInformationVector** inputs, volumeoptics::Batches& batches, vtkImageData* output)
{
  Run& run = *this->Current;
  const Owners owners(vtkImageData::GetData(inputs[0]), grid, run.Pieces, run.Process);
  const volumeoptics::ScalarSource source(grid, rows, this->Smoothing * grid.VoxelLength);
  Extent extent;
  output->GetExtent(extent.data());
  const auto tiles = volumeoptics::SplitIntoTiles(extent, LargestTile, VoxelsOfTile);
  vtkSMPThreadLocal<Counts> partial(run.Sums);
  const bool isComplete = batches.Run(tiles.size(), 1.0, [&](long long unit) {
    volumeoptics::GradientAlignedSampler sampler(
      grid, source, tiles[unit], this->StepLength * grid.VoxelLength);
    CountTile(tiles[unit], sampler, run.Scalars, run.Gradients, owners, partial.Local());
  });
  for (const Counts& part : partial)
  {
    const auto add = [](const std::vector<vtkIdType>& from, std::vector<vtkIdType>& to) {
      std::transform(from.begin(), from.end(), to.begin(), to.begin(), std::plus<>());
    };
    add(part.Pairs, run.Sums.Pairs);
    add(part.Gradients, run.Sums.Gradients);
  }
  return isComplete;
}

//------------------------------------------------------------------------------
// Adds up what the processes have counted. False if one of them has failed.
bool vtkGradientAlignedHistogram::Join(const volumeoptics::ProcessGroup& processes, bool isRight)
{
  if (!processes.All(isRight))
  {
    if (isRight)
    {
      vtkErrorMacro("Another process has no histogram of its piece. Look at its messages.");
    }
    return false;
  }
  processes.Sum(this->Current->Sums.Pairs);
  processes.Sum(this->Current->Sums.Gradients);
  return true;
}

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::Store(vtkInformationVector* outputs)
{
  const Run& run = *this->Current;
  StoreImage(run.Sums.Pairs, run.Scalars, run.Scalars, vtkImageData::GetData(outputs, 0));
  StoreImage(run.Sums.Gradients, run.Scalars, run.Gradients, vtkImageData::GetData(outputs, 1));
}

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "ScalarRange: " << this->ScalarRange[0] << ", " << this->ScalarRange[1] << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
  os << indent << "ResultOnAllProcesses: " << this->ResultOnAllProcesses << "\n";
}
