// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineKernel.h"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "LineKernel.cxx"
#include <hwy/foreach_target.h> // compiles this file once for each instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace volumeoptics
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;
using Quad = hn::CappedTag<float, 4>; // one lane on machines without vectors

HWY_INLINE hn::Vec<Quad> Mixed(const TableCorners& corners, std::size_t place)
{
  const Quad lanes;
  auto sum = hn::Mul(hn::Set(lanes, corners.Weights[0]), hn::LoadU(lanes, corners.Entries[0] + place));
  for (int i = 1; i < 4; ++i)
  {
    sum = hn::MulAdd(hn::Set(lanes, corners.Weights[i]), hn::LoadU(lanes, corners.Entries[i] + place), sum);
  }
  return sum;
}

void AddInterpolatedRow(const TableCorners& corners, const float* color, int harmonics, float* row)
{
  const Quad lanes;
  for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(harmonics); i += hn::Lanes(lanes))
  {
    const std::size_t channel = i % 4, place = 2 * (i - channel) + channel;
    const auto tinted = hn::Mul(hn::LoadU(lanes, color + channel), Mixed(corners, place));
    const auto light = hn::Add(tinted, Mixed(corners, place + 4));
    hn::StoreU(hn::Add(hn::LoadU(lanes, row + i), light), lanes, row + i);
  }
}

void AddScaledRow(const float* row, double factor, int count, double* sums)
{
  const hn::CappedTag<double, 4> lanes;
  const hn::Rebind<float, decltype(lanes)> narrow;
  const auto scale = hn::Set(lanes, factor);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += hn::Lanes(lanes))
  {
    const auto added = hn::PromoteTo(lanes, hn::LoadU(narrow, row + i));
    hn::StoreU(hn::MulAdd(scale, added, hn::LoadU(lanes, sums + i)), lanes, sums + i);
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace volumeoptics
{
HWY_EXPORT(AddInterpolatedRow);
HWY_EXPORT(AddScaledRow);

void AddInterpolated(const TableCorners& corners, const float color[4], int harmonics, float* row)
{
  HWY_DYNAMIC_DISPATCH(AddInterpolatedRow)(corners, color, harmonics, row);
}

void AddScaled(const float* row, double factor, int count, double* sums)
{
  HWY_DYNAMIC_DISPATCH(AddScaledRow)(row, factor, count, sums);
}
}
#endif
