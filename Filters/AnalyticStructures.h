// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fields made of many parts: packed ellipsoids and vortex tubes. A part of AnalyticFields.h.
//
// Each part is a bump (1 - q^2)^3 inside q < 1, q the distance relative to its reach, 0 outside (two
// continuous derivatives); parts overlap as independent coverages do: 1 - prod(1 - bump).

#ifndef AnalyticStructures_h
#define AnalyticStructures_h

#ifndef AnalyticFields_h
#include "AnalyticFields.h"
#endif

namespace analytic
{
template <class Number>
Number Bump(const Number& squaredDistance)
{
  if (ValueOf(squaredDistance) >= 1.0)
  {
    return Number(0.0);
  }
  const Number inside = Number(1.0) - squaredDistance;
  return inside * inside * inside;
}

struct PlacedEllipsoid
{
  Vector centre;
  Vector reach; // semi-axes where the bump ends
};

// The set of [Ament2015] figure 5, as far as its text tells: closely packed vertical ellipsoids
// whose anisotropy decreases from the centre to the boundary. It fills
// [-250/512, 250/512] x [-92/512, 92/512] x [-1, 1]: columns 7 across and 3 deep, whose ellipsoids are
// 5 times as high as wide in the middle column and nearly spheres in the outermost.
inline std::vector<PlacedEllipsoid> MakePackedEllipsoids()
{
  const int across = 7;
  const int deep = 3;
  const double width = 250.0 / 512.0 / across;
  const double depth = 92.0 / 512.0 / deep;
  std::vector<PlacedEllipsoid> ellipsoids;
  for (int i = 0; i < across; ++i)
  {
    const double fromCentre = std::abs(i - (across - 1) / 2.0) / ((across - 1) / 2.0);
    const double ratio = 5.0 - 4.0 * fromCentre;
    const int count = static_cast<int>(std::lround(1.0 / (ratio * width)));
    const double halfHeight = 1.0 / count;
    for (int j = 0; j < deep; ++j)
    {
      for (int k = 0; k < count; ++k)
      {
        // neighbours touch where the bump is .28 and their union .48: just below one half
        const Vector centre = { width * (2 * i + 1 - across), depth * (2 * j + 1 - deep),
          halfHeight * (2 * k + 1 - count) };
        ellipsoids.push_back({ centre, { 1.7 * width, 1.7 * depth, 1.7 * halfHeight } });
      }
    }
  }
  return ellipsoids;
}

template <class Number>
Number PackedEllipsoids(const std::array<Number, 3>& p, const std::vector<PlacedEllipsoid>& ellipsoids)
{
  Number uncovered(1.0);
  for (const PlacedEllipsoid& ellipsoid : ellipsoids)
  {
    Number q2(0.0);
    for (int i = 2; i >= 0 && ValueOf(q2) < 1.0; --i)
    {
      q2 = q2 + Square((p[i] - Number(ellipsoid.centre[i])) * Number(1.0 / ellipsoid.reach[i]));
    }
    if (ValueOf(q2) < 1.0)
    {
      uncovered = uncovered * (Number(1.0) - Bump(q2));
    }
  }
  return Number(1.0) - uncovered;
}

// A tube along one of the grid's axes whose centre line swings in both directions across it and whose
// radius swells and shrinks: amplitude sin(frequency t + phase), for the two directions and the radius.
struct VortexTube
{
  int axis = 0;
  std::array<double, 2> centre = { 0.0, 0.0 };
  std::array<double, 3> amplitude = { 0.0, 0.0, 0.0 };
  std::array<double, 3> frequency = { 0.0, 0.0, 0.0 };
  std::array<double, 3> phase = { 0.0, 0.0, 0.0 };
  double reach = 0.0;    // where the bump ends, on average
  double farReach = 0.0; // no bump reaches so far from the centre line, measured across the axis
};

// Reminiscent of the turbulent vortices of [Ament2015] figure 1: 60 tubes, 20 an axis, that wind
// about each other in [-1, 1]^3.
inline std::vector<VortexTube> MakeVortexTubes(std::uint32_t seed)
{
  const int count = 60;
  std::vector<VortexTube> tubes(count);
  for (int n = 0; n < count; ++n)
  {
    VortexTube& tube = tubes[n];
    // a number in [0, 1) for each purpose
    auto random = [n, seed](int purpose) { return 0.5 + 0.5 * HashNoise(n, purpose, 0, seed); };
    tube.axis = n % 3;
    tube.reach = 0.07 + 0.10 * random(0) * random(0);
    for (int i = 0; i < 2; ++i)
    {
      tube.centre[i] = 1.6 * random(1 + i) - 0.8;
      tube.amplitude[i] = 0.10 + 0.22 * random(3 + i);
      tube.frequency[i] = 1.5 + 3.5 * random(5 + i);
      tube.phase[i] = 2.0 * Pi * random(7 + i);
    }
    tube.amplitude[2] = 0.35 * random(9);
    tube.frequency[2] = 2.0 + 5.0 * random(10);
    tube.phase[2] = 2.0 * Pi * random(11);
    const double slope2 =
      Square(tube.amplitude[0] * tube.frequency[0]) + Square(tube.amplitude[1] * tube.frequency[1]);
    tube.farReach = tube.reach * (1.0 + tube.amplitude[2]) * std::sqrt(1.0 + slope2);
  }
  return tubes;
}

// Offset from the centre line in one of the two directions across the axis.
template <class Number>
Number Offset(const std::array<Number, 3>& p, const VortexTube& tube, int i, const Number& angle)
{
  return p[(tube.axis + 1 + i) % 3] - Number(tube.centre[i]) - Number(tube.amplitude[i]) * Sin(angle);
}

// Distance from the centre line over the reach, squared; the slope of the line shortens the former.
// Most tubes are far away: that is found out with as few sines as possible.
template <class Number>
Number SquaredDistance(const std::array<Number, 3>& p, const VortexTube& tube)
{
  const Number& along = p[tube.axis];
  for (int i = 0; i < 2; ++i)
  {
    const double fromCentre = std::abs(ValueOf(p[(tube.axis + 1 + i) % 3]) - tube.centre[i]);
    if (fromCentre > tube.amplitude[i] + tube.farReach)
    {
      return Number(1.0);
    }
  }
  Number distance2(0.0);
  std::array<Number, 2> angle;
  for (int i = 0; i < 2; ++i)
  {
    angle[i] = along * Number(tube.frequency[i]) + Number(tube.phase[i]);
    distance2 = distance2 + Square(Offset(p, tube, i, angle[i]));
    if (ValueOf(distance2) > Square(tube.farReach))
    {
      return Number(1.0);
    }
  }
  Number slope2(1.0);
  for (int i = 0; i < 2; ++i)
  {
    slope2 = slope2 + Square(Number(tube.amplitude[i] * tube.frequency[i]) * Cos(angle[i]));
  }
  const Number swell = Sin(along * Number(tube.frequency[2]) + Number(tube.phase[2]));
  const Number reach = Number(tube.reach) * (Number(1.0) + Number(tube.amplitude[2]) * swell);
  return distance2 / (slope2 * Square(reach));
}

template <class Number>
Number VortexTubes(const std::array<Number, 3>& p, const std::vector<VortexTube>& tubes)
{
  Number uncovered(1.0);
  for (const VortexTube& tube : tubes)
  {
    const Number distance2 = SquaredDistance(p, tube);
    if (ValueOf(distance2) < 1.0)
    {
      uncovered = uncovered * (Number(1.0) - Bump(distance2));
    }
  }
  return Number(1.0) - uncovered;
}
}

#endif
