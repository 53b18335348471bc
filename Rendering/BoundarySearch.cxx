// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundarySearch.h"

#include "MaterialSearch.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// A boundary with less than this share of the strongest one's counts is none.
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

// Of a boundary, relative to the distance of its materials, and to the widest pair of one material.
const double Softness = 0.05;
const double SoftnessOfVarying = 0.25;

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
  const double homogeneous = pairs.HomogeneousWidth();
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
  const double homogeneous = pairs.HomogeneousWidth();
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

// A boundary in bins.
struct Candidate
{
  double Strength;
  std::array<std::array<double, 2>, 2> Ranges;
  double Softness;
};

void AddTransitions(
  const PairCounts& pairs, const std::vector<double>& materials, std::vector<Candidate>& candidates)
{
  std::vector<Transition> transitions;
  for (std::size_t low = 0; low < materials.size(); ++low)
  {
    for (std::size_t high = low + 1; high < materials.size(); ++high)
    {
      transitions.push_back({ materials[low], materials[high] });
    }
  }
  MeasureStrengths(pairs, transitions);
  const double contrast = CommonContrast(pairs, transitions);
  for (const Transition& transition : transitions)
  {
    candidates.push_back({ transition.Strength,
      { RangeAround(materials, transition.Low, transition.High, contrast),
        RangeAround(materials, transition.High, transition.Low, contrast) },
      Softness * (transition.High - transition.Low) });
  }
}

void AddVarying(
  const PairCounts& pairs, const std::vector<double>& materials, std::vector<Candidate>& candidates)
{
  for (const VaryingMaterial& material : FindVaryingMaterials(pairs, materials))
  {
    candidates.push_back({ material.Strength, { material.NeighbourRange, material.Range },
      SoftnessOfVarying * pairs.HomogeneousWidth() });
  }
}

double ScalarAt(vtkImageData* histogram, double bin)
{
  return histogram->GetOrigin()[0] + (histogram->GetExtent()[0] + bin) * histogram->GetSpacing()[0];
}

LightingBoundary BoundaryOf(vtkImageData* histogram, const Candidate& candidate)
{
  LightingBoundary boundary;
  for (int side = 0; side < 2; ++side)
  {
    const std::array<double, 2>& bins = candidate.Ranges[side];
    boundary.Materials[side].Range = { ScalarAt(histogram, bins[0]), ScalarAt(histogram, bins[1]) };
  }
  boundary.Softness = candidate.Softness * histogram->GetSpacing()[0];
  return boundary;
}
}

std::vector<LightingBoundary> FindBoundaries(vtkImageData* histogram, int count)
{
  if (!PairCounts::IsUsable(histogram))
  {
    return {};
  }
  const PairCounts pairs(histogram);
  const std::vector<double> materials = FindMaterials(pairs);
  std::vector<Candidate> candidates;
  AddTransitions(pairs, materials, candidates);
  AddVarying(pairs, materials, candidates);
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Strength > b.Strength; });
  std::vector<LightingBoundary> boundaries;
  for (const Candidate& candidate : candidates)
  {
    const bool isStrong = candidate.Strength > LeastStrength * candidates.front().Strength;
    if (isStrong && static_cast<int>(boundaries.size()) < count)
    {
      boundaries.push_back(BoundaryOf(histogram, candidate));
    }
  }
  return boundaries;
}
}
