// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PreIntegration.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// In physical space a block of cells is taken as one where that changes no colour by more than this.
const double ColorTolerance = 1.0 / 512.0;

float Stored(double attenuation)
{
  return static_cast<float>(std::min(attenuation, LargestAttenuation));
}

void Write(const glm::dvec3& color, double attenuation, float* entry)
{
  for (int i = 0; i < 3; ++i)
  {
    entry[i] = static_cast<float>(color[i]);
  }
  entry[3] = Stored(attenuation);
}

void WriteMean(const Stretch& stretch, float* entry)
{
  // no attenuation over no width: nothing attenuates the colour either
  const Slab slab = Attenuate(stretch, 0.0);
  const bool isSeen = stretch.depth > LeastDepth;
  Write(isSeen ? stretch.emission / stretch.depth : UpwardColor(slab), stretch.depth / stretch.width, entry);
}

// The error of taking the block's colour as linear in its depth is this or less.
double ColorError(const Stretch& block, double scale)
{
  const glm::dvec3 spread = block.largest - block.least;
  return std::max({ spread.x, spread.y, spread.z }) * std::min(block.depth * scale / 8.0, 1.0);
}
}

//------------------------------------------------------------------------------
PreIntegration::PreIntegration(const TransferFunctions& functions, int size)
  : Size(size)
  , Stretches(CutIntoStretches(functions, 2 * (size - 1)))
{
  this->MakeHalfCells();
  this->MakeBlocks();
}

//------------------------------------------------------------------------------
void PreIntegration::MakeHalfCells()
{
  const int count = 2 * (this->Size - 1);
  this->Cells.resize(this->Size - 1);
  this->Blocks.emplace_back(count);
  int last = -1;
  for (const PlacedStretch& stretch : this->Stretches)
  {
    const int half =
      std::clamp(static_cast<int>((stretch.begin + stretch.width / 2.0) * count), 0, count - 1);
    Stretch& joined = this->Blocks[0][half];
    joined = half == last ? Join(joined, stretch) : static_cast<const Stretch&>(stretch);
    Slab& cell = this->Cells[half / 2];
    cell =
      half / 2 == last / 2 && last >= 0 ? Composite(cell, Attenuate(stretch, 1.0)) : Attenuate(stretch, 1.0);
    last = half;
  }
}

//------------------------------------------------------------------------------
void PreIntegration::MakeBlocks()
{
  while (this->Blocks.back().size() > 1)
  {
    const std::vector<Stretch>& parts = this->Blocks.back();
    std::vector<Stretch> blocks(parts.size() / 2);
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      blocks[i] = Join(parts[2 * i], parts[2 * i + 1]);
    }
    this->Blocks.push_back(std::move(blocks));
  }
}

//------------------------------------------------------------------------------
Stretch PreIntegration::AroundEntry(int entry) const
{
  const std::vector<Stretch>& halves = this->Blocks[0];
  if (entry == 0)
  {
    return halves.front();
  }
  return entry == this->Size - 1 ? halves.back() : Join(halves[2 * entry - 1], halves[2 * entry]);
}

//------------------------------------------------------------------------------
float* PreIntegration::EntryOf(int front, int back, float* table) const
{
  return table + 4 * (static_cast<std::size_t>(back) * this->Size + front);
}

//------------------------------------------------------------------------------
void PreIntegration::WriteRow(int row, float* table) const
{
  WriteMean(this->AroundEntry(row), this->EntryOf(row, row, table));
  Slab slab;
  for (int front = row - 1; front >= 0; --front)
  {
    slab = Composite(this->Cells[front], slab);
    Write(UpwardColor(slab), slab.depth / slab.width, this->EntryOf(front, row, table));
  }
  slab = Slab();
  for (int front = row + 1; front < this->Size; ++front)
  {
    slab = Composite(slab, this->Cells[front - 1]);
    Write(DownwardColor(slab), slab.depth / slab.width, this->EntryOf(front, row, table));
  }
}

//------------------------------------------------------------------------------
// Upwards to the row's scalar, and the same segments downwards from it.
void PreIntegration::WriteRow(int row, double length, float* table) const
{
  WriteMean(this->AroundEntry(row), this->EntryOf(row, row, table));
  for (int low = 0; low < row; ++low)
  {
    // the segment's length is spread over its scalars
    const double scale = length * (this->Size - 1) / (row - low);
    const Slab slab = this->Segment(low, row, scale);
    const double mean = slab.depth / length;
    Write(UpwardColor(slab), mean, this->EntryOf(low, row, table));
    Write(DownwardColor(slab), mean, this->EntryOf(row, low, table));
  }
}

//------------------------------------------------------------------------------
// Between two entries, by the largest blocks that are accurate enough.
Slab PreIntegration::Segment(int first, int last, double scale) const
{
  Slab slab;
  int at = 2 * first;
  const int end = 2 * last;
  while (at < end)
  {
    std::size_t level = 0;
    while (at % (2 << level) == 0 && at + (2 << level) <= end)
    {
      ++level;
    }
    while (level > 0 && ColorError(this->Blocks[level][at >> level], scale) > ColorTolerance)
    {
      --level;
    }
    slab = Composite(slab, Attenuate(this->Blocks[level][at >> level], scale));
    at += 1 << level;
  }
  return slab;
}

//------------------------------------------------------------------------------
std::vector<float> PreIntegration::Cumulative() const
{
  std::vector<float> sums = { 0.0F };
  double sum = 0.0;
  for (const Slab& cell : this->Cells)
  {
    sum += cell.depth;
    sums.push_back(Stored(sum));
  }
  return sums;
}

//------------------------------------------------------------------------------
// Whether the opacity is 0 where a stretch begins, on either side.
bool PreIntegration::EndsPeak(std::size_t stretch) const
{
  return stretch == 0 || stretch == this->Stretches.size() || this->Stretches[stretch - 1].transparentAbove ||
    this->Stretches[stretch].transparentBelow;
}

//------------------------------------------------------------------------------
// The entry at a place in [0, 1], up to rounding; -1 between entries.
int PreIntegration::EntryAt(double place) const
{
  const double entry = place * (this->Size - 1);
  return std::abs(entry - std::round(entry)) < 1.0e-6 ? static_cast<int>(std::lround(entry)) : -1;
}

//------------------------------------------------------------------------------
// Sums along the stretches that begin anew at each end of a peak. At the end itself the sum is that of the
// whole peak, so that the entries before it interpolate to the right value.
std::vector<float> PreIntegration::DepthsBehind() const
{
  std::vector<float> depths(2 * this->Size, 0.0F);
  double below = 0.0;
  for (std::size_t i = 0; i < this->Stretches.size(); ++i)
  {
    const PlacedStretch& stretch = this->Stretches[i];
    below = (this->EndsPeak(i) ? 0.0 : below) + stretch.depth;
    const int entry = this->EntryAt(stretch.begin + stretch.width);
    if (entry >= 0)
    {
      depths[2 * entry + 1] = Stored(below);
    }
  }
  double above = 0.0;
  for (std::size_t i = this->Stretches.size(); i-- > 0;)
  {
    above = (this->EndsPeak(i + 1) ? 0.0 : above) + this->Stretches[i].depth;
    const int entry = this->EntryAt(this->Stretches[i].begin);
    if (entry >= 0)
    {
      depths[2 * entry] = Stored(above);
    }
  }
  return depths;
}
}
