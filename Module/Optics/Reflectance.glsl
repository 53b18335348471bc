// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Reflectance models. Each returns f_s max(N.L, 0): 0 where the light is behind. Ward's is 0 where the
// viewer is behind, too; the lobes of the others reach there, as published.
// normal, major, minor: orthonormal; toLight, toViewer: unit, away from the point.

const float Pi = 3.14159265358979323846;

// Ward's roughness along the major axis ends here: ratio^gamma overflows, and a wider lobe only
// dims (the published form's albedo at normal incidence falls from .90 at .2 to .11 at 5).
const float LargestRoughness = 4.0;

// [Blinn1977]; [Ament2015] eq. 8. exponent in [0.01, 1e5].
float BlinnPhongReflection(vec3 normal, vec3 toLight, vec3 toViewer, float exponent)
{
  float cosLight = max(dot(normal, toLight), 0.0);
  vec3 between = toLight + toViewer;
  float cosHalf = dot(normal, between) / max(length(between), 1.0e-6);
  return cosHalf > 0.0 ? cosLight * pow(min(cosHalf, 1.0), exponent) : 0.0;
}

// Roughness along the major axis, [Ament2015] eq. 32: roughness ratio^scale, bounded.
// roughness in [1e-4, 1] (not its square); logRatio = ln(l2/l1) >= 0; scale gamma >= 0.
float WardMajorRoughness(float roughness, float logRatio, float scale)
{
  return roughness * exp(min(scale * logRatio, log(LargestRoughness / roughness)));
}

// [Ward1992]; [Ament2015] eqs 9-11. roughnessMajor in [1e-4, 4], roughnessMinor in [1e-4, 1].
// The published factor 1/sqrt(N.L N.V) times N.L has no bound at grazing view; with max(N.L, N.V)
// in its place it has, and both agree where N.L = N.V.
float WardReflection(vec3 normal, vec3 major, vec3 minor, vec3 toLight, vec3 toViewer, float roughnessMajor,
  float roughnessMinor)
{
  float cosLight = dot(normal, toLight);
  float cosViewer = dot(normal, toViewer);
  if (cosLight <= 0.0 || cosViewer <= 0.0)
  {
    return 0.0;
  }
  vec3 between = toLight + toViewer;
  float along = max(dot(normal, between), 1.0e-20);
  // exp(-1e4) is 0 in every precision: the bound keeps the squares finite
  float x = min(abs(dot(between, major)) / along / roughnessMajor, 100.0);
  float y = min(abs(dot(between, minor)) / along / roughnessMinor, 100.0);
  float peak = 1.0 / (4.0 * Pi * roughnessMajor * roughnessMinor);
  return peak * exp(-x * x - y * y) * cosLight / max(cosLight, cosViewer);
}

// Weight of the major axis, [Ament2015] eq. 34 by the layout of its figure 4: -1 where isotropic,
// towards 1 with growing ratio^scale. The minor axis has -1 (eq. 35), the normal 1.
float LafortuneMajorWeight(float logRatio, float scale)
{
  return 1.0 - 2.0 * exp(1.0 - exp(min(scale * logRatio, 80.0)));
}

// [Lafortune1997]; [Ament2015] eq. 12. exponent in [0.01, 1e5]. majorWeight = -1 is Phong's (R.V)^n.
float LafortuneReflection(vec3 normal, vec3 major, vec3 minor, vec3 toLight, vec3 toViewer, float majorWeight,
  float exponent)
{
  float cosLight = dot(normal, toLight);
  if (cosLight <= 0.0)
  {
    return 0.0;
  }
  float lobe = majorWeight * dot(major, toLight) * dot(major, toViewer) -
    dot(minor, toLight) * dot(minor, toViewer) + cosLight * dot(normal, toViewer);
  return lobe > 0.0 ? cosLight * pow(min(lobe, 1.0), exponent) : 0.0;
}
