// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Numbers that carry their gradient, for exact derivatives of formulas written once. A part of
// AnalyticFields.h.

#ifndef AnalyticDual_h
#define AnalyticDual_h

#include <array>
#include <cmath>

namespace analytic
{
using Vector = std::array<double, 3>;

// A number with its gradient. Arithmetic follows the rules of differentiation.
struct Dual
{
  double value = 0.0;
  Vector gradient = { 0.0, 0.0, 0.0 };

  Dual() = default;
  Dual(double constant)
    : value(constant)
  {
  }
  Dual(double number, const Vector& itsGradient)
    : value(number)
    , gradient(itsGradient)
  {
  }
};

// f(g) and the chain rule; slope = f'(g).
inline Dual Chain(const Dual& g, double value, double slope)
{
  return { value, { slope * g.gradient[0], slope * g.gradient[1], slope * g.gradient[2] } };
}

inline Dual Combine(double value, const Dual& a, double slopeA, const Dual& b, double slopeB)
{
  Dual result(value);
  for (int i = 0; i < 3; ++i)
  {
    result.gradient[i] = slopeA * a.gradient[i] + slopeB * b.gradient[i];
  }
  return result;
}

inline Dual operator+(const Dual& a, const Dual& b)
{
  return Combine(a.value + b.value, a, 1.0, b, 1.0);
}
inline Dual operator-(const Dual& a, const Dual& b)
{
  return Combine(a.value - b.value, a, 1.0, b, -1.0);
}
inline Dual operator*(const Dual& a, const Dual& b)
{
  return Combine(a.value * b.value, a, b.value, b, a.value);
}
inline Dual operator/(const Dual& a, const Dual& b)
{
  const double ratio = a.value / b.value;
  return Combine(ratio, a, 1.0 / b.value, b, -ratio / b.value);
}
inline Dual Sin(const Dual& a)
{
  return Chain(a, std::sin(a.value), std::cos(a.value));
}
inline Dual Cos(const Dual& a)
{
  return Chain(a, std::cos(a.value), -std::sin(a.value));
}
inline Dual Exp(const Dual& a)
{
  const double power = std::exp(a.value);
  return Chain(a, power, power);
}
// The root of a squared distance has no gradient at 0; there it counts as 0.
inline Dual Sqrt(const Dual& a)
{
  const double root = std::sqrt(a.value);
  return Chain(a, root, root > 0.0 ? 0.5 / root : 0.0);
}
inline double Sin(double a)
{
  return std::sin(a);
}
inline double Cos(double a)
{
  return std::cos(a);
}
inline double Exp(double a)
{
  return std::exp(a);
}
inline double Sqrt(double a)
{
  return std::sqrt(a);
}
inline double ValueOf(double a)
{
  return a;
}
inline double ValueOf(const Dual& a)
{
  return a.value;
}
}

#endif
