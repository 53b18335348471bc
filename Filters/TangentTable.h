// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Harmonics of what a segment of weight 1 sends to every viewer under lights that are no headlights, in a
// table over the tangent's directions.

#ifndef TangentTable_h
#define TangentTable_h

#include "HarmonicBasis.h"

#include <functional>
#include <vector>

namespace volumeoptics
{
class Batches;

class TangentTable
{
public:
  // Adds the mean radiance towards a viewer: body takes the segment's colour, highlight does not.
  using Radiance = std::function<void(
    const glm::dvec3& tangent, const glm::dvec3& toViewer, glm::dvec3& body, glm::dvec3& highlight)>;

  explicit TangentTable(const HarmonicBasis& basis);
  // False on abort.
  bool Prepare(const Radiance& radiance, Batches& batches, double progressAtEnd);
  // Adds radiance times area to row[harmonic][4].
  void Add(const glm::dvec3& tangent, const glm::dvec3& color, float* row) const;

private:
  const HarmonicBasis& Basis;
  int Size;
  std::vector<float> Values; // [place][harmonic][ChannelsOfTable]
};
}

#endif
