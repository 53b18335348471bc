// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A plane of numbers, smoothed and halved: the scales of vtkStructuralDissimilarity.

#ifndef PicturePlane_h
#define PicturePlane_h

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace picture
{
struct Plane
{
  int width = 0;
  int height = 0;
  std::vector<double> values;

  Plane(int itsWidth, int itsHeight)
    : width(itsWidth)
    , height(itsHeight)
    , values(static_cast<size_t>(itsWidth) * itsHeight)
  {
  }
  double& At(int x, int y) { return this->values[static_cast<size_t>(y) * this->width + x]; }
  double At(int x, int y) const { return this->values[static_cast<size_t>(y) * this->width + x]; }
};

// One side of a symmetric kernel, from the middle outwards.
inline std::vector<double> GaussianWindow()
{
  std::vector<double> weights(6);
  for (size_t i = 0; i < weights.size(); ++i)
  {
    const double distance = static_cast<double>(i) / 1.5;
    weights[i] = std::exp(-0.5 * distance * distance);
  }
  return weights;
}

inline std::vector<double> BinomialKernel()
{
  return { 6.0, 4.0, 1.0 };
}

// The mean of value(i) around `at` over [0, count), with the weights that lie inside.
template <class Value>
double WeightedMean(const std::vector<double>& kernel, int at, int count, Value value)
{
  const int radius = static_cast<int>(kernel.size()) - 1;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = std::max(at - radius, 0); i <= std::min(at + radius, count - 1); ++i)
  {
    const double weight = kernel[std::abs(i - at)];
    sum += weight * value(i);
    weights += weight;
  }
  return sum / weights;
}

template <class Row>
void ForEachRow(int height, Row row)
{
  vtkSMPTools::For(0, height, [&row](vtkIdType begin, vtkIdType end) {
    for (vtkIdType y = begin; y < end; ++y)
    {
      row(static_cast<int>(y));
    }
  });
}

inline Plane Smooth(const Plane& plane, const std::vector<double>& kernel)
{
  Plane across(plane.width, plane.height);
  ForEachRow(plane.height, [&](int y) {
    for (int x = 0; x < plane.width; ++x)
    {
      across.At(x, y) = WeightedMean(kernel, x, plane.width, [&](int i) { return plane.At(i, y); });
    }
  });
  Plane smooth(plane.width, plane.height);
  ForEachRow(plane.height, [&](int y) {
    for (int x = 0; x < plane.width; ++x)
    {
      smooth.At(x, y) = WeightedMean(kernel, y, plane.height, [&](int i) { return across.At(x, i); });
    }
  });
  return smooth;
}

inline Plane HalfSize(const Plane& plane)
{
  const Plane smooth = Smooth(plane, BinomialKernel());
  Plane half((plane.width + 1) / 2, (plane.height + 1) / 2);
  for (int y = 0; y < half.height; ++y)
  {
    for (int x = 0; x < half.width; ++x)
    {
      half.At(x, y) = smooth.At(2 * x, 2 * y);
    }
  }
  return half;
}
}

#endif
