// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RangeSearch.h"

#include "Batches.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace volumeoptics
{
namespace
{
using ValueRange = std::array<double, 2>;
const ValueRange Nothing = { 1.0, 0.0 };

ValueRange United(const ValueRange& a, const ValueRange& b)
{
  if (a[0] > a[1] || b[0] > b[1])
  {
    return a[0] > a[1] ? b : a;
  }
  return { std::min(a[0], b[0]), std::max(a[1], b[1]) };
}

ValueRange RangeOf(const ImageRows& rows, const Extent& box)
{
  std::vector<double> values(box[1] - box[0] + 1);
  ValueRange range = Nothing;
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      rows.Read(box[0], box[1], y, z, values.data());
      for (const double value : values)
      {
        range = std::isnan(value) ? range : United(range, { value, value });
      }
    }
  }
  return range;
}
}

void RangeSearch::Start(const Extent& whole, const Extent& sizeLike)
{
  const Extent slice = { whole[0], whole[1], whole[2], whole[3], 0, 0 };
  const long long slices = NumberOfVoxels(sizeLike) / NumberOfVoxels(slice);
  this->SlabSize = static_cast<int>(std::max(slices, 1LL));
  this->Slab = 0;
  this->HasKey = false;
  std::copy(Nothing.begin(), Nothing.end(), this->Range);
}

Extent RangeSearch::GetSlab(const Extent& whole) const
{
  Extent slab = whole;
  slab[4] = whole[4] + this->Slab * this->SlabSize;
  slab[5] = std::min(slab[4] + this->SlabSize - 1, whole[5]);
  return slab;
}

bool RangeSearch::Add(Batches& batches, const ImageRows& rows)
{
  const auto tiles = SplitIntoTiles(rows.GetBox(), 32, 1.0e6);
  std::vector<ValueRange> ranges(tiles.size(), Nothing);
  const bool isComplete =
    batches.Run(tiles.size(), 0.0, [&](long long unit) { ranges[unit] = RangeOf(rows, tiles[unit]); });
  for (const ValueRange& range : ranges)
  {
    const ValueRange united = United({ this->Range[0], this->Range[1] }, range);
    std::copy(united.begin(), united.end(), this->Range);
  }
  return isComplete;
}

bool RangeSearch::Next(const Extent& whole)
{
  ++this->Slab;
  return whole[4] + this->Slab * this->SlabSize <= whole[5];
}

void RangeSearch::Finish(const Key& key)
{
  this->Slab = -1;
  this->Found = key;
  this->HasKey = true;
}
}
