// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Real spherical harmonics Y_lm, orthonormal over the sphere, as [Schussman2004] eqs 18-23: cos(m phi)
// for m > 0, sin(|m| phi) for m < 0, with the sign (-1)^m. Written without angles: Y_lm is a polynomial
// in z times the real or imaginary part of (x + iy)^|m|, and so has no pole.
// Degrees l up to 12 are tested; directions are unit.

// Y_00.
const float ConstantHarmonic = 0.28209479177387814347;

// Y_mm over Y_(m-1)(m-1), without (x + iy). m >= 1.
float SectoralFactor(int m)
{
  float twice = 2.0 * float(m);
  return m == 1 ? -sqrt(3.0) : -sqrt((twice + 1.0) / twice);
}

// Real and imaginary part of (x + iy)^m times a factor, from those of m - 1.
vec2 NextAzimuth(vec2 azimuth, vec3 direction)
{
  return vec2(
    azimuth.x * direction.x - azimuth.y * direction.y, azimuth.x * direction.y + azimuth.y * direction.x);
}

// Factors of the recurrence in l, eq. 23 for orthonormal functions. l > m >= 0.
float LegendreGain(int l, int m)
{
  float square = float(l * l);
  return sqrt((4.0 * square - 1.0) / (square - float(m * m)));
}

float LegendreLoss(int l, int m)
{
  float square = float((l - 1) * (l - 1));
  return l == m + 1 ? 0.0 : sqrt((square - float(m * m)) / (4.0 * square - 1.0));
}

// The polynomial of l from those of l - 1 and l - 2.
float NextLegendre(float value, float before, float z, float gain, float loss)
{
  return gain * (z * value - loss * before);
}

// |m| <= l <= 12.
float SphericalHarmonic(int l, int m, vec3 direction)
{
  int order = m < 0 ? -m : m;
  vec2 azimuth = vec2(ConstantHarmonic, 0.0);
  for (int i = 1; i <= order; ++i)
  {
    azimuth = SectoralFactor(i) * NextAzimuth(azimuth, direction);
  }
  float value = 1.0;
  float before = 0.0;
  for (int i = order + 1; i <= l; ++i)
  {
    float next = NextLegendre(value, before, direction.z, LegendreGain(i, order), LegendreLoss(i, order));
    before = value;
    value = next;
  }
  return value * (m < 0 ? azimuth.y : azimuth.x);
}

// Integral of cos^n over [-pi/2, pi/2], or sin^n over [0, pi] (Wallis). n >= 0.
// sqrt(pi) Gamma((n + 1)/2)/Gamma(n/2 + 1): from n up to above 30, then the asymptotic series, whose
// next term there is 1e-14.
float WallisIntegral(float n)
{
  float product = 1.0;
  float x = n;
  for (int i = 0; i < 16; ++i)
  {
    if (x < 30.0)
    {
      product *= (x + 2.0) / (x + 1.0);
      x += 2.0;
    }
  }
  float w = x / 2.0 + 0.25;
  float u = 1.0 / (w * w);
  float series = 1.0 + u * (0.03125 + u * (-0.00439453125 + u * (0.0023345947265625 - u * 0.0025545359)));
  return product * 1.7724538509055160273 / sqrt(w * series);
}

// Integral of sin^power(theta) P_l(cos theta) over cos theta in [-1, 1]; 0 for odd l. power >= 0.
// A function of the angle to an axis T alone is zonal: its coefficients are 2 pi times such an integral
// times Y_lm(T).
float SineMoment(int l, float power)
{
  if (l - 2 * (l / 2) == 1)
  {
    return 0.0;
  }
  float moment = WallisIntegral(power + 1.0);
  for (int i = 0; i < l; i += 2)
  {
    float degree = float(i);
    moment *= -(power - degree) * (degree + 1.0) / ((power + degree + 3.0) * (degree + 2.0));
  }
  return moment;
}
