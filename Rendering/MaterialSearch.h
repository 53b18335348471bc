// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Finds materials in a histogram of pairs along the gradient. All scalars are bins.

#ifndef MaterialSearch_h
#define MaterialSearch_h

#include "PairCounts.h"

#include <array>

namespace volumeoptics
{
// The scalars that homogeneous regions have: the modes of the diagonal, rising.
std::vector<double> FindMaterials(const PairCounts& pairs);

// A material beyond all others without a homogeneous region, such as thin bone, whose scalar is another
// one at each place: its pairs have one end at its neighbour and the other one anywhere beyond.
struct VaryingMaterial
{
  double Strength;                      // counts of pairs with the neighbour
  std::array<double, 2> Range;          // its own
  std::array<double, 2> NeighbourRange; // apart from it
};

// At most one at each end of the scalars.
std::vector<VaryingMaterial> FindVaryingMaterials(
  const PairCounts& pairs, const std::vector<double>& materials);
}

#endif
