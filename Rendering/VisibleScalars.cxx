// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibleScalars.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
const float Never = std::numeric_limits<float>::infinity();

std::vector<double> SumsBelow(const std::vector<float>& table)
{
  std::vector<double> sums(table.size() + 1, 0.0);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    sums[i + 1] = sums[i] + std::clamp<double>(table[i], 0.0, 1.0);
  }
  return sums;
}

double Mean(const std::vector<double>& sumsBelow, int first, int last)
{
  return (sumsBelow[last + 1] - sumsBelow[first]) / (last + 1 - first);
}
}

//------------------------------------------------------------------------------
VisibleScalars::VisibleScalars(const std::vector<float>& table, const double coordinateRange[2], Ends ends,
  const std::vector<float>& leastGradients)
  : Least(1, std::vector<float>(table.size(), Never))
  , OpacitiesBelow(SumsBelow(table))
{
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    if (!(table[i] <= 0.0F))
    {
      this->Least[0][i] = leastGradients.empty() ? 0.0F : leastGradients[i];
    }
  }
  this->JoinEntries();
  const double width = coordinateRange[1] - coordinateRange[0];
  const double entries = static_cast<double>(table.size());
  const bool hasEdges = ends == Ends::Edges;
  this->Scale = (hasEdges ? entries : entries - 1.0) / width;
  this->Origin = coordinateRange[0] + (hasEdges ? 0.5 / this->Scale : 0.0);
  // the ray scales and shifts a scalar in single precision
  const double largest = std::max(std::abs(coordinateRange[0]), std::abs(coordinateRange[1]));
  this->Slack = LookUpSlack + 4.0 * std::numeric_limits<float>::epsilon() * entries * (1.0 + largest / width);
}

//------------------------------------------------------------------------------
void VisibleScalars::JoinEntries()
{
  const std::size_t size = this->Least[0].size();
  for (std::size_t half = 1; 2 * half <= size; half *= 2)
  {
    const std::vector<float>& halves = this->Least.back();
    std::vector<float> wholes(size - 2 * half + 1);
    for (std::size_t i = 0; i < wholes.size(); ++i)
    {
      wholes[i] = std::min(halves[i], halves[i + half]);
    }
    this->Least.push_back(std::move(wholes));
  }
}

//------------------------------------------------------------------------------
int VisibleScalars::Clamp(double position) const
{
  return static_cast<int>(std::clamp(position, 0.0, this->OpacitiesBelow.size() - 2.0));
}

//------------------------------------------------------------------------------
bool VisibleScalars::HasAny(double low, double high, float gradient) const
{
  const int first = this->Clamp((low - this->Origin) * this->Scale - this->Slack);
  const int last = this->Clamp((high - this->Origin) * this->Scale + this->Slack + 1.0);
  const int power = std::ilogb(last + 1 - first);
  const std::vector<float>& joined = this->Least[power]; // two that overlap
  return std::min(joined[first], joined[last + 1 - (1 << power)]) <= gradient;
}

//------------------------------------------------------------------------------
bool VisibleScalars::DependsOnGradient() const
{
  return !this->Least.empty() && std::any_of(this->Least[0].begin(), this->Least[0].end(), [](float least) {
    return least > 0.0F && least < Never;
  });
}

//------------------------------------------------------------------------------
void VisibleScalars::SetGradientOpacities(const std::vector<float>& table)
{
  this->GradientOpacitiesBelow = SumsBelow(table);
}

//------------------------------------------------------------------------------
double VisibleScalars::MeanOpacity(double low, double high, float gradient) const
{
  const int first = this->Clamp((low - this->Origin) * this->Scale);
  const int last = this->Clamp((high - this->Origin) * this->Scale);
  const double opacity = Mean(this->OpacitiesBelow, first, last);
  if (this->GradientOpacitiesBelow.empty())
  {
    return opacity;
  }
  const int steepest = static_cast<int>(this->GradientOpacitiesBelow.size()) - 2;
  return opacity *
    Mean(this->GradientOpacitiesBelow, 0, std::min(static_cast<int>(gradient * steepest), steepest));
}

//------------------------------------------------------------------------------
bool VisibleScalars::HasNaN() const
{
  return this->ShowsNaN || this->Least[0].front() < Never || this->Least[0].back() < Never;
}

//------------------------------------------------------------------------------
bool VisibleScalars::operator==(const VisibleScalars& other) const
{
  return this->Least == other.Least && this->Origin == other.Origin && this->Scale == other.Scale &&
    this->Slack == other.Slack && this->ShowsNaN == other.ShowsNaN;
}
