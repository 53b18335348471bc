// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// One boundary of a lighting transfer function: two materials and the coefficients of light on the
// boundary between them.

#ifndef LightingBoundary_h
#define LightingBoundary_h

#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

namespace volumeoptics
{
using LightingCoefficients = std::array<double, 3>; // ambient, diffuse, specular
inline constexpr const char* CoefficientNames[] = { "Ambient", "Diffuse", "Specular" };

struct LightingMaterial
{
  std::array<double, 2> Range = { 0.0, 0.0 };  // ordered
  vtkSmartPointer<vtkPiecewiseFunction> Curve; // instead of Range, where set

  // Weight of a scalar, in [0, 1].
  double Weight(double scalar, double softness) const;

  // Mean weight over [low, high], which may be a point.
  double MeanWeight(double low, double high, double softness) const;
};

struct LightingBoundary
{
  std::array<LightingMaterial, 2> Materials;
  double Softness = 0.0;
  LightingCoefficients Coefficients = { 0.0, 0.0, 0.0 };

  // Factor of the coefficients.
  double Weight(double s1, double s2) const;

  void Print(ostream& os, vtkIndent indent) const;
};

// Mean weights of both materials over each of `size` equal intervals of a range.
std::array<std::vector<double>, 2> MeanWeights(
  const LightingBoundary& boundary, const double range[2], int size);

// The factor of a pair that has no order.
double UnorderedPair(double a1, double b1, double a2, double b2);
}

#endif
