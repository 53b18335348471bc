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
  const std::vector<double> weighted = this->Basis.Weighted(directions);
  const int count = this->Basis.GetCount(), places = this->Size * this->Size;
  this->Values.assign(static_cast<std::size_t>(places) * count * ChannelsOfTable, 0.0F);
  return batches.Run(places, progressAtEnd, [&](long long place) {
    const glm::dvec2 index(place % this->Size, place / this->Size);
    const glm::dvec3 tangent = DirectionOf(index * (2.0 / (this->Size - 1)) - 1.0);
    std::vector<double> sums(count * ChannelsOfTable, 0.0);
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      glm::dvec3 body(0.0), highlight(0.0);
      radiance(tangent, directions[i].Direction, body, highlight);
      const double sine = glm::length(glm::cross(tangent, directions[i].Direction));
      const glm::dvec3 a = sine * body, b = sine * highlight;
      const double values[ChannelsOfTable] = { a.x, a.y, a.z, 0.0, b.x, b.y, b.z, 0.0 };
      const double* basis = &weighted[i * count];
      for (int j = 0; j < count * ChannelsOfTable; ++j)
      {
        sums[j] += basis[j / ChannelsOfTable] * values[j % ChannelsOfTable];
      }
    }
    std::copy(sums.begin(), sums.end(), this->Values.begin() + place * sums.size());
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
