// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibleScalars.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Of an entry, which textures divide into at least 256 parts.
const double LookUpSlack = 1.0 / 128.0;
}

//------------------------------------------------------------------------------
VisibleScalars::VisibleScalars(const std::vector<float>& table, const double coordinateRange[2], Ends ends)
  : Below(table.size() + 1)
  , OpacitiesBelow(table.size() + 1)
{
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    this->Below[i + 1] = this->Below[i] + (table[i] <= 0.0F ? 0 : 1);
    this->OpacitiesBelow[i + 1] = this->OpacitiesBelow[i] + std::clamp<double>(table[i], 0.0, 1.0);
  }
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
int VisibleScalars::Clamp(double position) const
{
  return static_cast<int>(std::clamp(position, 0.0, this->Below.size() - 2.0));
}

//------------------------------------------------------------------------------
bool VisibleScalars::HasAny(double low, double high) const
{
  const int first = this->Clamp((low - this->Origin) * this->Scale - this->Slack);
  const int last = this->Clamp((high - this->Origin) * this->Scale + this->Slack + 1.0);
  return this->Below[last + 1] > this->Below[first];
}

//------------------------------------------------------------------------------
double VisibleScalars::MeanOpacity(double low, double high) const
{
  const int first = this->Clamp((low - this->Origin) * this->Scale);
  const int last = this->Clamp((high - this->Origin) * this->Scale);
  return (this->OpacitiesBelow[last + 1] - this->OpacitiesBelow[first]) / (last + 1 - first);
}

//------------------------------------------------------------------------------
bool VisibleScalars::HasNaN() const
{
  const std::size_t size = this->Below.size() - 1;
  return this->ShowsNaN || this->Below[1] > 0 || this->Below[size] > this->Below[size - 1];
}

//------------------------------------------------------------------------------
bool VisibleScalars::operator==(const VisibleScalars& other) const
{
  return this->Below == other.Below && this->Origin == other.Origin && this->Scale == other.Scale &&
    this->Slack == other.Slack && this->ShowsNaN == other.ShowsNaN;
}
