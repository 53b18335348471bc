// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fields of charges and atoms: what [Kraus2005] shows. A part of AnalyticFields.h.

#ifndef AnalyticPotentials_h
#define AnalyticPotentials_h

#ifndef AnalyticFields_h
#include "AnalyticFields.h"
#endif

namespace analytic
{
template <class Number>
Number SquaredDistanceFrom(const std::array<Number, 3>& p, const Vector& centre)
{
  return Square(p[0] - Number(centre[0])) + Square(p[1] - Number(centre[1])) +
    Square(p[2] - Number(centre[2]));
}

// strength/r of a charge at the centre, rounded off within r = strength: 1 at the charge. Charges of other
// strengths are scaled copies of each other, and so are all their isosurfaces.
template <class Number>
Number CoulombPotential(const Number& squaredDistance, double strength)
{
  return Number(strength) / Sqrt(squaredDistance + Number(strength * strength));
}

// Three charges, each twice as strong as the next, like [Kraus2005] figures 1 to 3. Half of the sum: below 1.
template <class Number>
Number CoulombPotentials(const std::array<Number, 3>& p, double strength)
{
  return Number(0.5) *
    (CoulombPotential(SquaredDistanceFrom(p, { 0.0, 0.0, -0.45 }), strength) +
      CoulombPotential(SquaredDistanceFrom(p, { -0.35, 0.0, 0.35 }), strength / 2.0) +
      CoulombPotential(SquaredDistanceFrom(p, { 0.4, 0.0, 0.55 }), strength / 4.0));
}

// Density of the hydrogen atom's orbital 3d_z2, (3 z^2 - r^2)^2 exp(-2 r/(3 a)), over its largest value,
// which is on the axis at z = 6 a = radius: two lobes and a ring.
template <class Number>
Number HydrogenOrbital(const std::array<Number, 3>& p, double radius)
{
  const Number z2 = Square(p[2] * Number(1.0 / radius));
  const Number r2 = (Square(p[0]) + Square(p[1])) * Number(1.0 / (radius * radius)) + z2;
  const Number shape = Number(0.5) * (Number(3.0) * z2 - r2);
  return Square(shape) * Exp(Number(4.0) * (Number(1.0) - Sqrt(r2)));
}

// Corners of a truncated icosahedron, the atoms of C60, at this distance from the centre.
inline std::vector<Vector> MakeBuckyball(double radius)
{
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  const std::array<Vector, 3> corners = { Vector{ 0.0, 1.0, 3.0 * golden },
    Vector{ 1.0, 2.0 + golden, 2.0 * golden }, Vector{ golden, 2.0, 2.0 * golden + 1.0 } };
  const double scale = radius / std::sqrt(9.0 * golden + 10.0);
  std::vector<Vector> atoms;
  for (const Vector& corner : corners)
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      if (corner[0] == 0.0 && (signs & 1) != 0)
      {
        continue;
      }
      for (int turn = 0; turn < 3; ++turn)
      {
        Vector atom;
        for (int i = 0; i < 3; ++i)
        {
          atom[(i + turn) % 3] = (signs >> i & 1 ? -scale : scale) * corner[i];
        }
        atoms.push_back(atom);
      }
    }
  }
  return atoms;
}

// Atoms as bumps that reach to the next atom, overlapping as independent coverages do.
template <class Number>
Number Buckyball(const std::array<Number, 3>& p, const std::vector<Vector>& atoms, double radius)
{
  const double reach = 0.45 * radius;
  Number uncovered(1.0);
  for (const Vector& atom : atoms)
  {
    const Number q2 = SquaredDistanceFrom(p, atom) * Number(1.0 / (reach * reach));
    if (ValueOf(q2) < 1.0)
    {
      uncovered = uncovered * (Number(1.0) - Bump(q2));
    }
  }
  return Number(1.0) - uncovered;
}
}

#endif
