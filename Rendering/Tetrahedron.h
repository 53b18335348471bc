// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A tetrahedron and the gradients of its barycentric weights: a quantity given at its points is
// linear within it, and has the gradient sum_i value_i WeightGradients_i.

#ifndef Tetrahedron_h
#define Tetrahedron_h

#include <glm/glm.hpp>

#include <array>
#include <cmath>

struct Tetrahedron
{
  // Volume over the cube of the longest edge below which nothing of double's digits is left in the
  // gradients.
  static constexpr double SmallestRelativeVolume = 1e-14;

  explicit Tetrahedron(const std::array<glm::dvec3, 4>& points)
    : Points(points)
  {
    const glm::dvec3 a = points[1] - points[0], b = points[2] - points[0], c = points[3] - points[0];
    this->SixfoldVolume = glm::dot(a, glm::cross(b, c));
    this->WeightGradients[1] = glm::cross(b, c) / this->SixfoldVolume;
    this->WeightGradients[2] = glm::cross(c, a) / this->SixfoldVolume;
    this->WeightGradients[3] = glm::cross(a, b) / this->SixfoldVolume;
    this->WeightGradients[0] =
      -(this->WeightGradients[1] + this->WeightGradients[2] + this->WeightGradients[3]);
  }

  // False for flat ones, for coincident points and for coordinates that are no numbers.
  bool HasVolume() const
  {
    double longest = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        longest = std::max(longest, glm::length(this->Points[i] - this->Points[j]));
      }
    }
    const double volume = std::abs(this->SixfoldVolume) / 6.0;
    return std::isfinite(longest) && volume > SmallestRelativeVolume * longest * longest * longest;
  }

  // The differences are taken first: a constant has the gradient zero, not a rounding's.
  glm::dvec3 GetGradient(const glm::dvec4& values) const
  {
    return (values[1] - values[0]) * this->WeightGradients[1] +
      (values[2] - values[0]) * this->WeightGradients[2] + (values[3] - values[0]) * this->WeightGradients[3];
  }

  std::array<glm::dvec3, 4> Points;
  std::array<glm::dvec3, 4> WeightGradients;
  double SixfoldVolume;
};

#endif
