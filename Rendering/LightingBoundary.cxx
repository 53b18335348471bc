// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingBoundary.h"

#include "Optics.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// Points of a curve that the mean over a texel is taken of.
const int CurveSamples = 16;

double CurveWeight(vtkPiecewiseFunction* curve, double scalar)
{
  const double weight = curve->GetSize() > 0 ? curve->GetValue(scalar) : 0.0;
  return std::isfinite(weight) ? std::clamp(weight, 0.0, 1.0) : 0.0;
}
}

double LightingMaterial::Weight(double scalar, double softness) const
{
  return this->Curve ? CurveWeight(this->Curve, scalar)
                     : optics::SoftRange(scalar, this->Range[0], this->Range[1], softness);
}

double LightingMaterial::MeanWeight(double low, double high, double softness) const
{
  if (!(high > low))
  {
    return this->Weight(low, softness);
  }
  double mean = 0.0;
  if (this->Curve)
  {
    for (int i = 0; i < CurveSamples; ++i)
    {
      mean += CurveWeight(this->Curve, low + (i + 0.5) / CurveSamples * (high - low)) / CurveSamples;
    }
    return mean;
  }
  // Linear between these ends: the middle's value is the mean.
  const double ends[] = { this->Range[0] - softness, this->Range[0], this->Range[1],
    this->Range[1] + softness };
  for (int piece = 0; piece < 3; ++piece)
  {
    const double first = std::max(low, ends[piece]);
    const double last = std::min(high, ends[piece + 1]);
    if (last > first)
    {
      mean += (last - first) / (high - low) * this->Weight(first + 0.5 * (last - first), softness);
    }
  }
  return std::min(mean, 1.0);
}

double UnorderedPair(double a1, double b1, double a2, double b2)
{
  return std::max(a1 * b2, a2 * b1);
}

double LightingBoundary::Weight(double s1, double s2) const
{
  const LightingMaterial& a = this->Materials[0];
  const LightingMaterial& b = this->Materials[1];
  return UnorderedPair(a.Weight(s1, this->Softness), b.Weight(s1, this->Softness),
    a.Weight(s2, this->Softness), b.Weight(s2, this->Softness));
}

void LightingBoundary::Print(ostream& os, vtkIndent indent) const
{
  for (const LightingMaterial& material : this->Materials)
  {
    os << indent << "Range: " << material.Range[0] << ", " << material.Range[1]
       << ", Curve: " << material.Curve.Get() << "\n";
  }
  os << indent << "Softness: " << this->Softness << "\n";
  for (int i = 0; i < 3; ++i)
  {
    os << indent << CoefficientNames[i] << ": " << this->Coefficients[i] << "\n";
  }
}

std::array<std::vector<double>, 2> MeanWeights(
  const LightingBoundary& boundary, const double range[2], int size)
{
  std::array<std::vector<double>, 2> weights;
  const double width = range[1] / size - range[0] / size;
  for (int side = 0; side < 2; ++side)
  {
    for (int i = 0; i < size; ++i)
    {
      const double first = range[0] + i * width;
      const double last = range[0] + (i + 1) * width;
      weights[side].push_back(
        boundary.Materials[side].MeanWeight(std::min(first, last), std::max(first, last), boundary.Softness));
    }
  }
  return weights;
}
}
