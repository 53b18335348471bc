// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundarySearch.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace volumeoptics
{
namespace
{
// Pairs as far apart as this share of the range still are of one material.
const double HomogeneousWidth = 1.0 / 32.0;
// The diagonal's counts are smoothed by this share of the range (standard deviation).
const double DiagonalSmoothing = 1.0 / 128.0;
// Two modes are two materials if the counts fall below this share of the lower one between them.
const double LargestValley = 0.5;
// What holds less than these shares of all counts is no material, and of the strongest boundary none.
const double LeastMaterial = 0.002;
const double LeastStrength = 0.05;
// A boundary is looked for in the middle of its transition, where its pairs are farthest apart.
const double MiddleWidth = 0.2;
// Positions between the materials end here, so that their logits are finite: at 1 % and 99 %.
const double LeastPosition = 0.01;
const int ContrastBins = 48;
const double LargestContrast = 9.2; // of 1 % and 99 %
// Below (42 % and 58 %) the transition is so much longer than the step that it is no boundary, but a ramp.
const double LeastContrast = 0.6;
const double ContrastTolerance = 0.35;

// Counts with S1 >= S2, at the bins' numbers.
class PairCounts
{
public:
  explicit PairCounts(vtkImageData* histogram)
    : Bins(histogram->GetDimensions()[0])
    , Counts(static_cast<std::size_t>(Bins) * Bins)
  {
    vtkDataArray* values = histogram->GetPointData()->GetScalars();
    for (int row = 0; row < this->Bins; ++row)
    {
      for (int column = 0; column < this->Bins; ++column)
      {
        const double count = values->GetComponent(column + static_cast<vtkIdType>(row) * this->Bins, 0);
        this->Counts[std::min(row, column) * this->Bins + std::max(row, column)] +=
          count > 0.0 && std::isfinite(count) ? count : 0.0;
      }
    }
  }

  int GetBins() const { return this->Bins; }
  double Total() const { return std::accumulate(this->Counts.begin(), this->Counts.end(), 0.0); }

  // visit(upper bin, lower bin, count) of all counts above 0.
  template <typename Visit>
  void ForEach(const Visit& visit) const
  {
    for (int lower = 0; lower < this->Bins; ++lower)
    {
      for (int upper = lower; upper < this->Bins; ++upper)
      {
        const double count = this->Counts[lower * this->Bins + upper];
        if (count > 0.0)
        {
          visit(upper, lower, count);
        }
      }
    }
  }

private:
  int Bins;
  std::vector<double> Counts;
};

std::vector<double> Smoothed(const std::vector<double>& values, double deviation)
{
  const int reach = static_cast<int>(std::ceil(3.0 * deviation));
  const int count = static_cast<int>(values.size());
  std::vector<double> smoothed(values.size());
  for (int i = 0; i < count; ++i)
  {
    double weights = 0.0;
    for (int offset = -reach; offset <= reach; ++offset)
    {
      const double weight =
        offset == 0 ? 1.0 : std::exp(-0.5 * offset * offset / std::max(deviation * deviation, 1e-9));
      weights += weight;
      smoothed[i] += i + offset >= 0 && i + offset < count ? weight * values[i + offset] : 0.0;
    }
    smoothed[i] /= weights;
  }
  return smoothed;
}

// Counts near the diagonal by the middle of their pair.
std::vector<double> DiagonalCounts(const PairCounts& pairs)
{
  std::vector<double> diagonal(pairs.GetBins());
  pairs.ForEach([&](int upper, int lower, double count) {
    if (upper - lower <= HomogeneousWidth * pairs.GetBins())
    {
      diagonal[(upper + lower) / 2] += count / 2.0;
      diagonal[(upper + lower + 1) / 2] += count / 2.0;
    }
  });
  return diagonal;
}

bool IsApart(const std::vector<double>& profile, int mode, int other)
{
  const auto ends = std::minmax(mode, other);
  const double valley = *std::min_element(profile.begin() + ends.first, profile.begin() + ends.second + 1);
  return valley < LargestValley * std::min(profile[mode], profile[other]);
}

// Bins of the materials, rising.
std::vector<double> MaterialBins(const PairCounts& pairs)
{
  const std::vector<double> diagonal = DiagonalCounts(pairs);
  const double deviation = DiagonalSmoothing * pairs.GetBins();
  const std::vector<double> profile = Smoothed(diagonal, deviation);
  std::vector<int> order(profile.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return profile[a] > profile[b]; });
  const double total = pairs.Total();
  const int reach = std::max(static_cast<int>(std::lround(2.0 * deviation)), 1);
  std::vector<int> modes;
  std::vector<double> materials;
  for (const int bin : order)
  {
    const bool isNew =
      std::all_of(modes.begin(), modes.end(), [&](int mode) { return IsApart(profile, bin, mode); });
    double mass = 0.0;
    double moment = 0.0;
    for (int i = std::max(bin - reach, 0); i <= std::min(bin + reach, pairs.GetBins() - 1); ++i)
    {
      mass += diagonal[i];
      moment += diagonal[i] * i;
    }
    if (isNew && mass > LeastMaterial * total)
    {
      modes.push_back(bin);
      materials.push_back(moment / mass);
    }
  }
  std::sort(materials.begin(), materials.end());
  return materials;
}

// Two materials, in bins.
struct Transition
{
  double Low;
  double High;
  double Strength = 0.0;

  // How far apart a pair is, as the difference of the logits of its relative positions: along a
  // transition by a smooth step it is nearly the same everywhere, and the same for all materials. Below 0
  // if the pair is not in the middle of the transition.
  double Contrast(double upper, double lower) const
  {
    const double width = this->High - this->Low;
    const double middle = ((upper + lower) / 2.0 - this->Low) / width;
    if (std::abs(middle - 0.5) > MiddleWidth || (upper - lower) / width > 1.0 + MiddleWidth)
    {
      return -1.0;
    }
    const auto logit = [&](double bin) {
      const double position = std::clamp((bin - this->Low) / width, LeastPosition, 1.0 - LeastPosition);
      return std::log(position / (1.0 - position));
    };
    return logit(upper) - logit(lower);
  }
};

// The commonest contrast, which depends on the blur and the step.
double CommonContrast(const PairCounts& pairs, const std::vector<Transition>& transitions)
{
  std::vector<double> contrasts(ContrastBins);
  const double homogeneous = HomogeneousWidth * pairs.GetBins();
  pairs.ForEach([&](int upper, int lower, double count) {
    for (const Transition& transition : transitions)
    {
      const double contrast = transition.Contrast(upper, lower);
      if (contrast > LeastContrast && upper - lower > homogeneous)
      {
        const int bin = static_cast<int>(contrast / LargestContrast * ContrastBins);
        contrasts[std::min(bin, ContrastBins - 1)] += count;
      }
    }
  });
  const std::vector<double> smoothed = Smoothed(contrasts, 1.0);
  const auto largest = std::max_element(smoothed.begin(), smoothed.end());
  return ((largest - smoothed.begin()) + 0.5) / ContrastBins * LargestContrast;
}

// Each pair counts for the transition whose contrast it fits best.
void MeasureStrengths(const PairCounts& pairs, std::vector<Transition>& transitions)
{
  const double common = CommonContrast(pairs, transitions);
  const double homogeneous = HomogeneousWidth * pairs.GetBins();
  pairs.ForEach([&](int upper, int lower, double count) {
    Transition* best = nullptr;
    double least = ContrastTolerance * common;
    for (Transition& transition : transitions)
    {
      const double contrast = transition.Contrast(upper, lower);
      if (contrast > LeastContrast && upper - lower > homogeneous && std::abs(contrast - common) < least)
      {
        least = std::abs(contrast - common);
        best = &transition;
      }
    }
    if (best)
    {
      best->Strength += count;
    }
  });
}

// From the material to where the transition's pairs are farthest apart, but not as far as half the way to
// another material.
std::array<double, 2> RangeAround(
  const std::vector<double>& materials, double material, double towards, double contrast)
{
  const double width = std::abs(towards - material);
  const double reach = 1.0 / (1.0 + std::exp(contrast / 2.0)); // of the farthest pairs
  const double inward = std::min(reach + 0.1, 0.4) * width;
  const double outward = 0.1 * width;
  std::array<double, 2> range = { material - (towards > material ? outward : inward),
    material + (towards > material ? inward : outward) };
  for (const double other : materials)
  {
    const double half = 0.5 * (material + other);
    if (other < material)
    {
      range[0] = std::max(range[0], half);
    }
    else if (other > material)
    {
      range[1] = std::min(range[1], half);
    }
  }
  return range;
}

bool IsUsable(vtkImageData* histogram)
{
  vtkDataArray* values = histogram ? histogram->GetPointData()->GetScalars() : nullptr;
  return values && values->GetNumberOfTuples() > 0 &&
    histogram->GetDimensions()[0] == histogram->GetDimensions()[1];
}

double ScalarAt(vtkImageData* histogram, double bin)
{
  return histogram->GetOrigin()[0] + (histogram->GetExtent()[0] + bin) * histogram->GetSpacing()[0];
}
}

std::vector<double> FindMaterials(vtkImageData* histogram)
{
  std::vector<double> materials;
  if (IsUsable(histogram))
  {
    materials = MaterialBins(PairCounts(histogram));
    std::transform(materials.begin(), materials.end(), materials.begin(),
      [&](double bin) { return ScalarAt(histogram, bin); });
  }
  return materials;
}

std::vector<LightingBoundary> FindBoundaries(vtkImageData* histogram, int count)
{
  if (!IsUsable(histogram))
  {
    return {};
  }
  const PairCounts pairs(histogram);
  const std::vector<double> materials = MaterialBins(pairs);
  std::vector<Transition> transitions;
  for (std::size_t low = 0; low < materials.size(); ++low)
  {
    for (std::size_t high = low + 1; high < materials.size(); ++high)
    {
      transitions.push_back({ materials[low], materials[high] });
    }
  }
  MeasureStrengths(pairs, transitions);
  std::stable_sort(transitions.begin(), transitions.end(),
    [](const Transition& a, const Transition& b) { return a.Strength > b.Strength; });
  const double contrast = CommonContrast(pairs, transitions);
  std::vector<LightingBoundary> boundaries;
  for (const Transition& transition : transitions)
  {
    const bool isStrong = transition.Strength > LeastStrength * transitions.front().Strength;
    if (isStrong && static_cast<int>(boundaries.size()) < count)
    {
      LightingBoundary boundary;
      const double ends[] = { transition.Low, transition.High };
      for (int side = 0; side < 2; ++side)
      {
        const auto bins = RangeAround(materials, ends[side], ends[1 - side], contrast);
        boundary.Materials[side].Range = { ScalarAt(histogram, bins[0]), ScalarAt(histogram, bins[1]) };
      }
      boundary.Softness = 0.05 * (transition.High - transition.Low) * histogram->GetSpacing()[0];
      boundaries.push_back(boundary);
    }
  }
  return boundaries;
}
}
