// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A plant of branches and leaves, after [Lum2004] figure 11. A part of AnalyticFields.h.
//
// Branches are 1, leaves one half and air 0. All of them are ellipsoids with soft edges, so that the edge
// of every branch passes through the leaves' value.

#ifndef AnalyticPlant_h
#define AnalyticPlant_h

#ifndef AnalyticFields_h
#include "AnalyticFields.h"
#endif

namespace analytic
{
struct TurnedEllipsoid
{
  Vector centre;
  std::array<Vector, 3> axes; // unit, over the semi-axis
};

struct Plant
{
  std::vector<TurnedEllipsoid> branches;
  std::vector<TurnedEllipsoid> leaves;
};

inline Vector Along(const Vector& start, const Vector& direction, double length)
{
  return { start[0] + length * direction[0], start[1] + length * direction[1],
    start[2] + length * direction[2] };
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

// Long along one direction, thin along its cross product with `side`.
inline TurnedEllipsoid MakeEllipsoid(
  const Vector& centre, const Vector& along, const Vector& side, const Vector& semiAxes)
{
  const Vector first = Normalized(along);
  const Vector third = Normalized(Cross(first, side));
  const Vector second = Cross(third, first);
  TurnedEllipsoid ellipsoid{ centre, { first, second, third } };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double& component : ellipsoid.axes[axis])
    {
      component /= semiAxes[axis];
    }
  }
  return ellipsoid;
}

// Leaves around the outer half of a branch, each turned by the golden angle against the one before.
inline void AddLeaves(Plant& plant, const Vector& start, const Vector& direction, double length)
{
  const int count = 7;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.39996 * i;
    const Vector across = Normalized(Cross(direction, { std::cos(angle), std::sin(angle), 0.3 }));
    const Vector outwards = Normalized(Along(across, direction, 0.5));
    const Vector stalk = Along(start, direction, length * (0.45 + 0.55 * i / (count - 1)));
    plant.leaves.push_back(
      MakeEllipsoid(Along(stalk, outwards, 0.15), outwards, direction, { 0.15, 0.075, 0.035 }));
  }
}

// A stem and eight branches in [-1, 1]^3, each with its leaves.
inline Plant MakePlant()
{
  Plant plant;
  const Vector up = { 0.0, 0.0, 1.0 };
  const Vector aside = { 1.0, 0.0, 0.0 };
  plant.branches.push_back(MakeEllipsoid({ 0.0, 0.0, -0.2 }, up, aside, { 0.95, 0.09, 0.09 }));
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 2.39996 * i;
    const double height = -0.5 + 0.13 * i;
    const double length = 0.68 - 0.04 * i;
    const Vector direction = Normalized({ std::cos(angle), std::sin(angle), 0.55 });
    const Vector start = { 0.0, 0.0, height };
    plant.branches.push_back(MakeEllipsoid(
      Along(start, direction, length / 2.0), direction, up, { length / 2.0 + 0.06, 0.055, 0.055 }));
    AddLeaves(plant, start, direction, length);
  }
  return plant;
}

// 1 in the ellipsoid, 0 outside; over a third of the semi-axis from 0.9 to 0.1. What is left beyond the
// cut is less than the rounding of a float.
template <class Number>
Number Softly(const std::array<Number, 3>& p, const TurnedEllipsoid& ellipsoid)
{
  const double steepness = 5.0;
  const double cut = 5.5;
  Number q2(0.0);
  for (int axis = 0; axis < 3 && ValueOf(q2) < cut; ++axis)
  {
    Number along(0.0);
    for (int i = 0; i < 3; ++i)
    {
      along = along + (p[i] - Number(ellipsoid.centre[i])) * Number(ellipsoid.axes[axis][i]);
    }
    q2 = q2 + Square(along);
  }
  return ValueOf(q2) < cut ? Number(1.0) / (Number(1.0) + Exp(Number(steepness) * (q2 - Number(1.0))))
                           : Number(0.0);
}

template <class Number>
Number Union(const std::array<Number, 3>& p, const std::vector<TurnedEllipsoid>& ellipsoids)
{
  Number uncovered(1.0);
  for (const TurnedEllipsoid& ellipsoid : ellipsoids)
  {
    uncovered = uncovered * (Number(1.0) - Softly(p, ellipsoid));
  }
  return Number(1.0) - uncovered;
}

template <class Number>
Number BranchesAndLeaves(const std::array<Number, 3>& p, const Plant& plant)
{
  const Number branches = Union(p, plant.branches);
  return branches + (Number(1.0) - branches) * Number(0.5) * Union(p, plant.leaves);
}
}

#endif
