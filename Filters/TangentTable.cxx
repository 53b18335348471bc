// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TangentTable.h"

#include "Batches.h"
#include "LineKernel.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// Directions up to their sign on a square: the upper half of the octahedron.
glm::dvec2 SquareOf(const glm::dvec3& direction)
{
  const glm::dvec3 upper = direction.z < 0.0 ? -direction : direction;
  const double sum = std::abs(upper.x) + std::abs(upper.y) + upper.z;
  return glm::dvec2(upper.x + upper.y, upper.x - upper.y) / sum;
}

glm::dvec3 DirectionOf(const glm::dvec2& square)
{
  const double x = (square.x + square.y) / 2.0, y = (square.x - square.y) / 2.0;
  return glm::normalize(glm::dvec3(x, y, 1.0 - std::abs(x) - std::abs(y)));
}

// Tangents along each side of the table, and rows of directions to the viewer: as many as keep
// interpolation and quadrature below the truncation (TestLineVoxelSegments).
int SizeOfTable(int order)
{
  return 21 + 4 * order;
}

int RowsOfTable(int order)
{
  return 16 + order;
}
}

TangentTable::TangentTable(const HarmonicBasis& basis)
  : Basis(basis)
  , Size(SizeOfTable(basis.GetMaximumOrder()))
{
}

bool TangentTable::Prepare(const Radiance& radiance, Batches& batches, double progressAtEnd)
{
  const std::vector<WeightedDirection> directions =
    GaussDirections(RowsOfTable(this->Basis.GetMaximumOrder()));
  const int count = this->Basis.GetCount(), places = this->Size * this->Size;
  const int padded = (count + 3) / 4 * 4; // for AddScaled()
  const std::vector<double> weighted = this->Basis.Weighted(directions);
  std::vector<float> rows(directions.size() * padded, 0.0F);
  for (std::size_t i = 0; i < weighted.size(); ++i)
  {
    rows[i / count * padded + i % count] = static_cast<float>(weighted[i]);
  }
  this->Values.assign(static_cast<std::size_t>(places) * count * ChannelsOfTable, 0.0F);
  return batches.Run(places, progressAtEnd, [&](long long place) {
    const glm::dvec2 index(place % this->Size, place / this->Size);
    const glm::dvec3 tangent = DirectionOf(index * (2.0 / (this->Size - 1)) - 1.0);
    std::vector<double> sums(padded * ChannelsOfTable, 0.0); // [channel][harmonic]
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      glm::dvec3 light[2] = { glm::dvec3(0.0), glm::dvec3(0.0) };
      radiance(tangent, directions[i].Direction, light[0], light[1]);
      const double sine = glm::length(glm::cross(tangent, directions[i].Direction));
      for (const int c : { 0, 1, 2, 4, 5, 6 })
      {
        AddScaled(&rows[i * padded], sine * light[c / 4][c % 4], padded, &sums[c * padded]);
      }
    }
    float* entry = &this->Values[place * count * ChannelsOfTable];
    for (int i = 0; i < count * ChannelsOfTable; ++i)
    {
      entry[i] = static_cast<float>(sums[i % ChannelsOfTable * padded + i / ChannelsOfTable]);
    }
  });
}

void TangentTable::Add(const glm::dvec3& tangent, const glm::dvec3& color, float* row) const
{
  const glm::dvec2 place = (SquareOf(tangent) + 1.0) * 0.5 * (this->Size - 1.0);
  const glm::ivec2 corner = glm::clamp(glm::ivec2(place), 0, this->Size - 2);
  const glm::vec2 after = place - glm::dvec2(corner), before = 1.0F - after;
  const std::ptrdiff_t entry = this->Basis.GetCount() * ChannelsOfTable;
  const float* first = &this->Values[(static_cast<std::ptrdiff_t>(corner.y) * this->Size + corner.x) * entry];
  const float* above = first + this->Size * entry;
  const TableCorners corners{ { first, first + entry, above, above + entry },
    { before.x * before.y, after.x * before.y, before.x * after.y, after.x * after.y } };
  const float tint[4] = { static_cast<float>(color.x), static_cast<float>(color.y),
    static_cast<float>(color.z), 0.0F };
  AddInterpolated(corners, tint, this->Basis.GetCount(), row);
}
}
