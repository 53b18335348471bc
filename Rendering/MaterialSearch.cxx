// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MaterialSearch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace volumeoptics
{
namespace
{
// The diagonal's counts are smoothed by this share of the range (standard deviation).
const double DiagonalSmoothing = 1.0 / 128.0;
// Two modes are two materials if the counts fall below this share of the lower one between them.
const double LargestValley = 0.5;
// What holds less than this share of all counts is no material.
const double LeastMaterial = 0.002;
// Beyond its neighbour the diagonal of a varying material stays below this share of the neighbour's: in
// noise and in ramps all scalars are as homogeneous as any other.
const double LargestDiagonal = 0.1;
// Materials hold this share of the diagonal, modes by chance less.
const double LeastShareInModes = 0.5;
// Where a varying material is looked for, where its range begins, and where its neighbour's ends: distances
// from its neighbour relative to the widest pair of one material. The softness has room between them.
const double BeyondNeighbour = 2.0;
const double StartOfVarying = 1.5;
const double EndOfNeighbour = 0.75;

int ReachOfMode(const PairCounts& pairs)
{
  return std::max(static_cast<int>(std::lround(2.0 * DiagonalSmoothing * pairs.GetBins())), 1);
}

// Counts around a bin, and their mean bin.
std::pair<double, double> MassAround(const std::vector<double>& diagonal, int bin, int reach)
{
  double mass = 0.0;
  double moment = 0.0;
  const int last = static_cast<int>(diagonal.size()) - 1;
  for (int i = std::max(bin - reach, 0); i <= std::min(bin + reach, last); ++i)
  {
    mass += diagonal[i];
    moment += diagonal[i] * i;
  }
  return { mass, moment / std::max(mass, 1e-300) };
}

bool IsApart(const std::vector<double>& profile, int mode, int other)
{
  const auto ends = std::minmax(mode, other);
  const double valley = *std::min_element(profile.begin() + ends.first, profile.begin() + ends.second + 1);
  return valley < LargestValley * std::min(profile[mode], profile[other]);
}

// The largest share of the neighbour's mode that the diagonal has beyond it.
double DiagonalBeyond(const PairCounts& pairs, double neighbour, int direction)
{
  const std::vector<double> profile = Smoothed(pairs.Diagonal(), DiagonalSmoothing * pairs.GetBins());
  const double distance = BeyondNeighbour * pairs.HomogeneousWidth();
  double largest = 0.0;
  for (int bin = 0; bin < pairs.GetBins(); ++bin)
  {
    largest = direction * (bin - neighbour) > distance ? std::max(largest, profile[bin]) : largest;
  }
  return largest / std::max(profile[std::lround(neighbour)], 1e-300);
}

double CountsBeyond(const PairCounts& pairs, double neighbour, int direction)
{
  const double distance = BeyondNeighbour * pairs.HomogeneousWidth();
  double counts = 0.0;
  pairs.ForEach([&](int upper, int lower, double count) {
    const int near = direction > 0 ? lower : upper;
    const int far = direction > 0 ? upper : lower;
    const bool isNear = std::abs(near - neighbour) <= ReachOfMode(pairs);
    counts += isNear && direction * (far - neighbour) > distance ? count : 0.0;
  });
  return counts;
}

double MassBeyond(
  const PairCounts& pairs, const std::vector<double>& diagonal, double neighbour, int direction)
{
  const double distance = BeyondNeighbour * pairs.HomogeneousWidth();
  double mass = 0.0;
  for (int bin = 0; bin < pairs.GetBins(); ++bin)
  {
    mass += direction * (bin - neighbour) > distance ? diagonal[bin] : 0.0;
  }
  return mass;
}

bool IsVarying(const PairCounts& pairs, double neighbour, int direction)
{
  return CountsBeyond(pairs, neighbour, direction) > LeastMaterial * pairs.Total() &&
    DiagonalBeyond(pairs, neighbour, direction) < LargestDiagonal;
}

// A varying material has modes, too, by chance: what is beyond a material is none if the diagonal's counts
// there are more between the modes than in them, and fewer than the pairs with this material.
void RemoveModesOfVarying(const PairCounts& pairs, int direction, std::vector<double>& materials)
{
  const std::vector<double> diagonal = pairs.Diagonal();
  const std::vector<double> all = materials;
  for (const double neighbour : all)
  {
    const auto isBeyond = [&](double material) { return direction * (material - neighbour) > 0.0; };
    double inModes = 0.0;
    for (const double material : materials)
    {
      const int bin = static_cast<int>(std::lround(material));
      inModes += isBeyond(material) ? MassAround(diagonal, bin, ReachOfMode(pairs)).first : 0.0;
    }
    const bool isByChance = inModes > 0.0 && inModes < CountsBeyond(pairs, neighbour, direction) &&
      inModes < LeastShareInModes * MassBeyond(pairs, diagonal, neighbour, direction);
    if (isByChance && IsVarying(pairs, neighbour, direction))
    {
      materials.erase(std::remove_if(materials.begin(), materials.end(), isBeyond), materials.end());
    }
  }
}

// The modes of the diagonal, rising.
std::vector<double> ModesOf(const PairCounts& pairs)
{
  const std::vector<double> diagonal = pairs.Diagonal();
  const std::vector<double> profile = Smoothed(diagonal, DiagonalSmoothing * pairs.GetBins());
  std::vector<int> order(profile.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return profile[a] > profile[b]; });
  const double total = pairs.Total();
  const int reach = ReachOfMode(pairs);
  std::vector<int> modes;
  std::vector<double> materials;
  for (const int bin : order)
  {
    const bool isNew =
      std::all_of(modes.begin(), modes.end(), [&](int mode) { return IsApart(profile, bin, mode); });
    const auto [mass, mean] = MassAround(diagonal, bin, reach);
    if (isNew && mass > LeastMaterial * total)
    {
      modes.push_back(bin);
      materials.push_back(mean);
    }
  }
  std::sort(materials.begin(), materials.end());
  return materials;
}

std::array<double, 2> Ordered(double a, double b)
{
  return { std::min(a, b), std::max(a, b) };
}
}

std::vector<double> FindMaterials(const PairCounts& pairs)
{
  std::vector<double> materials = ModesOf(pairs);
  for (const int direction : { -1, 1 })
  {
    RemoveModesOfVarying(pairs, direction, materials);
  }
  return materials;
}

std::vector<VaryingMaterial> FindVaryingMaterials(
  const PairCounts& pairs, const std::vector<double>& materials)
{
  std::vector<VaryingMaterial> found;
  const double width = pairs.HomogeneousWidth();
  for (const int direction : { -1, 1 })
  {
    const double neighbour = materials.empty() ? 0.0 : direction < 0 ? materials.front() : materials.back();
    if (!materials.empty() && IsVarying(pairs, neighbour, direction))
    {
      const double end = direction < 0 ? -0.5 : pairs.GetBins() - 0.5;
      found.push_back({ CountsBeyond(pairs, neighbour, direction),
        Ordered(neighbour + direction * StartOfVarying * width, end),
        Ordered(neighbour - direction * width, neighbour + direction * EndOfNeighbour * width) });
    }
  }
  return found;
}
}
