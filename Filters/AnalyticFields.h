// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scalar fields in closed form, with exact gradients, in double.
//
// Each formula is written once, for any number type: with double it gives the value, with Dual the
// value and its gradient (forward differentiation, exact but for rounding). vtkAnalyticVolumeSource
// samples these fields, tests and the reference renderer take them as the truth.
//
// Quadrics (Sphere, Ellipsoid, Cylinder, Torus) are 1/(1 + q^2), q the distance from the centre,
// the axis or the ring, relative to the radius in that direction: 1 in the middle, one half on the
// surface, towards 0 outside.

#ifndef AnalyticFields_h
#define AnalyticFields_h

#include "AnalyticDual.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace analytic
{
// What the fields depend on; lengths in world units.
struct Parameters
{
  Vector semiAxes = { 0.4, 0.4, 0.8 };
  Vector axis = { 0.0, 0.0, 1.0 }; // of Cylinder, Torus and LinearRamp; any length but 0
  double radius = 0.5;             // of Sphere, Cylinder, the ring of Torus, HydrogenOrbital, Buckyball
  double strength = 0.2;           // of CoulombPotential, and of the strongest of CoulombPotentials
  double minorRadius = 0.2;        // of Torus
  double noiseAmplitude = 0.05;    // of NoisyHomogeneous
  double noiseCellSize = 1.0 / 32.0;
  std::uint32_t seed = 1;
};

const double Pi = 3.14159265358979323846;

template <class Number>
Number Square(const Number& a)
{
  return a * a;
}

template <class Number>
Number Dot(const Vector& a, const std::array<Number, 3>& b)
{
  return Number(a[0]) * b[0] + Number(a[1]) * b[1] + Number(a[2]) * b[2];
}

inline Vector Normalized(const Vector& a)
{
  const double length = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return length > 0.0 ? Vector{ a[0] / length, a[1] / length, a[2] / length } : Vector{ 0.0, 0.0, 1.0 };
}

template <class Number>
Number Quadric(const Number& squaredDistance)
{
  return Number(1.0) / (Number(1.0) + squaredDistance);
}

// [Marschner1994] eq. 4: (1 - sin(pi z/2) + alpha (1 + cos(2 pi f cos(pi r/2))))/(2 (1 + alpha)),
// f = 6, alpha = 1/4, on [-1, 1]^3.
template <class Number>
Number MarschnerLobb(const std::array<Number, 3>& p)
{
  const double frequency = 6.0;
  const double alpha = 0.25;
  const Number r = Sqrt(Square(p[0]) + Square(p[1]));
  const Number ripple = Cos(Number(2.0 * Pi * frequency) * Cos(r * Number(Pi / 2.0)));
  return (Number(1.0) - Sin(p[2] * Number(Pi / 2.0)) + Number(alpha) * (Number(1.0) + ripple)) *
    Number(0.5 / (1.0 + alpha));
}

template <class Number>
Number Ellipsoid(const std::array<Number, 3>& p, const Vector& semiAxes)
{
  Number q2(0.0);
  for (int i = 0; i < 3; ++i)
  {
    q2 = q2 + Square(p[i] * Number(1.0 / semiAxes[i]));
  }
  return Quadric(q2);
}

template <class Number>
Number Cylinder(const std::array<Number, 3>& p, const Vector& axis, double radius)
{
  const Vector unit = Normalized(axis);
  const Number along = Dot(unit, p);
  Number across2(0.0);
  for (int i = 0; i < 3; ++i)
  {
    across2 = across2 + Square(p[i] - along * Number(unit[i]));
  }
  return Quadric(across2 * Number(1.0 / (radius * radius)));
}

template <class Number>
Number Torus(const std::array<Number, 3>& p, const Vector& axis, double radius, double minorRadius)
{
  const Vector unit = Normalized(axis);
  const Number along = Dot(unit, p);
  Number across2(0.0);
  for (int i = 0; i < 3; ++i)
  {
    across2 = across2 + Square(p[i] - along * Number(unit[i]));
  }
  const Number fromRing2 = Square(Sqrt(across2) - Number(radius)) + Square(along);
  return Quadric(fromRing2 * Number(1.0 / (minorRadius * minorRadius)));
}

// (1 + position along the axis)/2: 0 to 1 between -1 and 1, and on beyond.
template <class Number>
Number LinearRamp(const std::array<Number, 3>& p, const Vector& axis)
{
  return Number(0.5) + Number(0.5) * Dot(Normalized(axis), p);
}

// Integer hash to [-1, 1]; the same on every machine.
inline double HashNoise(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed)
{
  std::uint64_t h = 0x9E3779B97F4A7C15ull * (static_cast<std::uint64_t>(x) + 0x632BE5ABull) +
    0xC2B2AE3D27D4EB4Full * (static_cast<std::uint64_t>(y) + 0x85157AF5ull) +
    0x165667B19E3779F9ull * (static_cast<std::uint64_t>(z) + 0x58F38DEDull) + seed * 0xD6E8FEB86659FD93ull;
  h = (h ^ (h >> 32)) * 0xD6E8FEB86659FD93ull;
  h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9ull;
  h ^= h >> 32;
  return static_cast<double>(h >> 11) / 4503599627370496.0 - 1.0;
}

// Random values on a lattice, blended by the quintic that keeps two derivatives continuous.
template <class Number>
Number LatticeNoise(const std::array<Number, 3>& p, double cellSize, std::uint32_t seed)
{
  std::array<Number, 3> weight;
  std::array<std::int64_t, 3> cell;
  for (int i = 0; i < 3; ++i)
  {
    const Number u = p[i] * Number(1.0 / cellSize);
    const double floor = std::floor(ValueOf(u));
    const Number t = u - Number(floor);
    cell[i] = static_cast<std::int64_t>(floor);
    weight[i] = t * t * t * (Number(10.0) + t * (Number(6.0) * t - Number(15.0)));
  }
  Number sum(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    Number product(
      HashNoise(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1), seed));
    for (int i = 0; i < 3; ++i)
    {
      product = product * ((corner >> i & 1) ? weight[i] : Number(1.0) - weight[i]);
    }
    sum = sum + product;
  }
  return sum;
}

// One half everywhere, plus noise of the given amplitude.
template <class Number>
Number NoisyHomogeneous(const std::array<Number, 3>& p, const Parameters& parameters)
{
  return Number(0.5) +
    Number(parameters.noiseAmplitude) * LatticeNoise(p, parameters.noiseCellSize, parameters.seed);
}
}

#include "AnalyticStructures.h"

#include "AnalyticPotentials.h"

#include "AnalyticPlant.h"

namespace analytic
{
enum FieldType
{
  MarschnerLobbField = 0,
  SphereField,
  EllipsoidField,
  CylinderField,
  TorusField,
  PackedEllipsoidsField,
  VortexTubesField,
  LinearRampField,
  NoisyHomogeneousField,
  CoulombPotentialField,
  CoulombPotentialsField,
  HydrogenOrbitalField,
  BuckyballField,
  PlantField,
  NumberOfFields
};

// One of the fields, ready for evaluation from any number of threads.
class AnalyticField
{
public:
  explicit AnalyticField(int field, const Parameters& parameters = Parameters())
    : Field(field)
    , Settings(parameters)
    , Ellipsoids(field == PackedEllipsoidsField ? MakePackedEllipsoids() : std::vector<PlacedEllipsoid>())
    , Tubes(field == VortexTubesField ? MakeVortexTubes(parameters.seed) : std::vector<VortexTube>())
    , Greenery(field == PlantField ? MakePlant() : Plant())
    , Atoms(field == BuckyballField ? MakeBuckyball(parameters.radius) : std::vector<Vector>())
  {
  }

  double Value(const Vector& p) const { return this->Evaluate<double>(p); }

  // The value and its exact gradient per world length.
  Dual ValueAndGradient(const Vector& p) const
  {
    std::array<Dual, 3> position;
    for (int i = 0; i < 3; ++i)
    {
      position[i].value = p[i];
      position[i].gradient[i] = 1.0;
    }
    return this->Evaluate<Dual>(position);
  }

private:
  template <class Number>
  Number Evaluate(const std::array<Number, 3>& p) const
  {
    const double r = this->Settings.radius;
    switch (this->Field)
    {
      case SphereField:
        return Ellipsoid(p, { r, r, r });
      case EllipsoidField:
        return Ellipsoid(p, this->Settings.semiAxes);
      case CylinderField:
        return Cylinder(p, this->Settings.axis, r);
      case TorusField:
        return Torus(p, this->Settings.axis, r, this->Settings.minorRadius);
      case PackedEllipsoidsField:
        return PackedEllipsoids(p, this->Ellipsoids);
      case VortexTubesField:
        return VortexTubes(p, this->Tubes);
      case LinearRampField:
        return LinearRamp(p, this->Settings.axis);
      case NoisyHomogeneousField:
        return NoisyHomogeneous(p, this->Settings);
      case CoulombPotentialField:
        return CoulombPotential(SquaredDistanceFrom(p, { 0.0, 0.0, 0.0 }), this->Settings.strength);
      case CoulombPotentialsField:
        return CoulombPotentials(p, this->Settings.strength);
      case HydrogenOrbitalField:
        return HydrogenOrbital(p, r);
      case PlantField:
        return BranchesAndLeaves(p, this->Greenery);
      case BuckyballField:
        return Buckyball(p, this->Atoms, r);
      default:
        return MarschnerLobb(p);
    }
  }

  int Field;
  Parameters Settings;
  std::vector<PlacedEllipsoid> Ellipsoids;
  std::vector<VortexTube> Tubes;
  Plant Greenery;
  std::vector<Vector> Atoms;
};
}

#endif
