// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Quadrature for tests of lines: on an interval and on the sphere.

#ifndef LineQuadrature_h
#define LineQuadrature_h

#include "Directions.h"

#include <glm/glm.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace
{
// Nodes and weights of Gauss and Legendre on [-1, 1].
[[maybe_unused]] std::vector<std::pair<double, double>> GaussNodes(int count)
{
  std::vector<std::pair<double, double>> nodes;
  for (int i = 0; i < count; ++i)
  {
    double x = std::cos(TwoPi / 2.0 * (i + 0.75) / (count + 0.5));
    double slope = 1.0;
    for (int step = 0; step < 20; ++step)
    {
      slope = count * (x * std::legendre(count, x) - std::legendre(count - 1, x)) / (x * x - 1.0);
      x -= std::legendre(count, x) / slope;
    }
    nodes.emplace_back(x, 2.0 / ((1.0 - x * x) * slope * slope));
  }
  return nodes;
}

// Of a smooth function: 64 panels of 12 points.
template <class Function>
double Integrate(const Function& function, double from, double to)
{
  static const auto nodes = GaussNodes(12);
  const int panels = 64;
  const double half = (to - from) / panels / 2.0;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i)
  {
    for (const auto& [x, weight] : nodes)
    {
      sum += weight * half * function(from + half * (2.0 * i + 1.0 + x));
    }
  }
  return sum;
}

struct SphereNode
{
  glm::dvec3 Direction;
  double Weight; // all together: 4 pi
};

// Exact up to degree 2 rows - 1 and columns - 1.
[[maybe_unused]] std::vector<SphereNode> GaussSphere(int rows, int columns)
{
  std::vector<SphereNode> nodes;
  for (const auto& [z, weight] : GaussNodes(rows))
  {
    for (int j = 0; j < columns; ++j)
    {
      const double azimuth = TwoPi * (j + 0.5) / columns;
      nodes.push_back({ Direction(std::acos(z), azimuth), weight * TwoPi / columns });
    }
  }
  return nodes;
}
}

#endif
