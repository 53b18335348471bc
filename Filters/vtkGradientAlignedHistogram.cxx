// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGradientAlignedHistogram.h"

#include "Batches.h"
#include "GradientAlignedSampler.h"
#include "ParameterRange.h"
#include "RangeSearch.h"

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

// Which points belong to another piece.
class Owners
{
public:
  Owners(vtkImageData* image, double factor)
    : Image(image)
    , Ghosts(image->GetPointGhostArray())
    , Factor(factor)
  {
  }

  bool IsForeign(int x, int y, int z) const
  {
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

void Store(const std::vector<vtkIdType>& counts, const Axis& x, const Axis& y, vtkImageData* image)
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

//------------------------------------------------------------------------------
vtkGradientAlignedHistogram::vtkGradientAlignedHistogram()
{
  this->SetNumberOfOutputPorts(2);
}

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
  if (!this->HasExtent(inputs))
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
int vtkGradientAlignedHistogram::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData::GetData(outputs, 1)->Initialize();
  return this->Superclass::RequestData(request, inputs, outputs);
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
bool vtkGradientAlignedHistogram::FindRange(
  const volumeoptics::ImageRows& rows, volumeoptics::Batches& batches, double range[2]) const
{
  std::copy(this->ScalarRange, this->ScalarRange + 2, range);
  if (!(range[0] <= range[1]))
  {
    volumeoptics::RangeSearch search;
    search.Start(rows.GetBox(), rows.GetBox());
    if (!search.Add(batches, rows))
    {
      return false;
    }
    std::copy(search.GetRange(), search.GetRange() + 2, range);
  }
  const double width = range[1] / this->NumberOfBins - range[0] / this->NumberOfBins;
  if (range[0] <= range[1] && width < std::numeric_limits<double>::min())
  {
    // half a unit, or more where that is below the value's precision
    const double half = std::max(0.5, std::abs(range[0]) * 1.0e-6);
    range[0] -= half;
    range[1] += half;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkGradientAlignedHistogram::ComputeArrays(const ImageGrid& grid, const volumeoptics::ImageRows& rows,
  vtkInformationVector** inputs, volumeoptics::Batches& batches, vtkImageData* output)
{
  double range[2];
  if (!this->FindRange(rows, batches, range))
  {
    return false;
  }
  if (range[0] > range[1]) // nothing to count
  {
    range[0] = 0.0;
    range[1] = 1.0;
  }
  const Axis scalars = { range[0], range[1], this->NumberOfBins };
  const double steepest = (range[1] / 2.0 - range[0] / 2.0) / grid.VoxelLength;
  const Axis gradients = { 0.0, steepest, this->NumberOfBins };
  const Owners owners(vtkImageData::GetData(inputs[0]), grid.Factor);
  const volumeoptics::ScalarSource source(grid, rows, this->Smoothing * grid.VoxelLength);
  Extent counted; // the whole, or a piece
  output->GetExtent(counted.data());
  const auto tiles = volumeoptics::SplitIntoTiles(counted, LargestTile, VoxelsOfTile);
  Counts counts;
  counts.Pairs.resize(static_cast<std::size_t>(this->NumberOfBins) * this->NumberOfBins);
  counts.Gradients.resize(counts.Pairs.size());
  vtkSMPThreadLocal<Counts> partial(counts);
  const bool isComplete = batches.Run(tiles.size(), 1.0, [&](long long unit) {
    volumeoptics::GradientAlignedSampler sampler(
      grid, source, tiles[unit], this->StepLength * grid.VoxelLength);
    CountTile(tiles[unit], sampler, scalars, gradients, owners, partial.Local());
  });
  for (const Counts& part : partial)
  {
    const auto add = std::plus<>();
    std::transform(part.Pairs.begin(), part.Pairs.end(), counts.Pairs.begin(), counts.Pairs.begin(), add);
    std::transform(
      part.Gradients.begin(), part.Gradients.end(), counts.Gradients.begin(), counts.Gradients.begin(), add);
  }
  if (isComplete)
  {
    Store(counts.Pairs, scalars, scalars, output);
    Store(counts.Gradients, scalars, gradients, vtkImageData::SafeDownCast(this->GetOutputDataObject(1)));
  }
  return isComplete;
}

//------------------------------------------------------------------------------
void vtkGradientAlignedHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "ScalarRange: " << this->ScalarRange[0] << ", " << this->ScalarRange[1] << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
}
