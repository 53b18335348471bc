// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A list of cases on which a formula is compared between precisions.

#ifndef FunctionCaseList_h
#define FunctionCaseList_h

#include "Directions.h"
#include "Optics.h"

#include <cmath>
#include <vector>

namespace
{
// Arguments are floats, so that every precision is given the same ones. (A unit vector is then off by
// 6e-8, for all alike.)
struct FunctionCase
{
  int Function = 0;
  glm::vec3 Normal{ 0.0f, 0.0f, 1.0f };
  glm::vec3 ToLight{ 0.0f, 0.0f, 1.0f };
  glm::vec3 ToViewer{ 0.0f, 0.0f, 1.0f };
  glm::vec3 Major{ 1.0f, 0.0f, 0.0f };
  glm::vec3 P{ 0.0f, 0.0f, 0.0f };
};

class FunctionCaseList
{
public:
  std::vector<FunctionCase> Cases;

protected:
  void Add(int function, double x, double y = 0.0, double z = 0.0)
  {
    FunctionCase c;
    c.Function = function;
    c.P = glm::vec3(x, y, z);
    this->Cases.push_back(c);
  }

  static std::vector<double> Powers(double from, double to, int count)
  {
    std::vector<double> values;
    values.reserve(count);
    for (int i = 0; i < count; ++i)
    {
      values.push_back(from * std::pow(to / from, i / (count - 1.0)));
    }
    return values;
  }

  // Every fourth one a pole or near one.
  glm::dvec3 NormalFor(int i)
  {
    if (i % 4 != 1)
    {
      return this->Random.OnSphere();
    }
    const double rho = i % 8 == 1 ? 0.0 : std::pow(10.0, this->Random.Uniform(-30.0, -1.0));
    const double azimuth = this->Random.Uniform(0.0, TwoPi);
    return glm::dvec3(
      rho * std::cos(azimuth), rho * std::sin(azimuth), (i % 3 ? 1.0 : -1.0) * std::sqrt(1.0 - rho * rho));
  }

  RandomDirections Random{ 10 };
};
}

#endif
