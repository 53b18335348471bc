// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// All spherical harmonics up to an order at once, the recurrence's factors computed beforehand.

#ifndef HarmonicBasis_h
#define HarmonicBasis_h

#include "SphereDirections.h"

#include <glm/glm.hpp>

#include <vector>

namespace volumeoptics
{
class HarmonicBasis
{
public:
  static constexpr int LargestOrder = 12;
  static constexpr int LargestCount = (LargestOrder + 1) * (LargestOrder + 1);

  // evenOnly: leaves the harmonics of odd degree out, which are those odd in the direction.
  HarmonicBasis(int maximumOrder, bool evenOnly);

  int GetMaximumOrder() const { return this->MaximumOrder; }
  int GetCount() const { return static_cast<int>(this->Degrees.size()); }
  // Degree l, and l (l + 1) + m, of each harmonic, by rising degree.
  int GetDegree(int i) const { return this->Degrees[i]; }
  int GetIndex(int i) const { return this->Indices[i]; }
  // direction: unit; values: GetCount() of them.
  void Evaluate(const glm::dvec3& direction, double* values) const;
  // [direction][harmonic], times the direction's weight: for integrals over the sphere.
  std::vector<double> Weighted(const std::vector<WeightedDirection>& directions) const;

private:
  struct Step
  {
    double Gain, Loss;
    int Cosine, Sine; // places among the values; -1: left out
  };

  int PlaceOf(int l, int m) const;

  int MaximumOrder;
  std::vector<int> Degrees;
  std::vector<int> Indices;
  std::vector<double> Sectoral;
  std::vector<Step> Steps; // for m from 0, for l from m
};
}

#endif
