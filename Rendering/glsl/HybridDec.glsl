// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after CoefficientsOfTable.

uniform float in_opticsDensityFade;

vec3 opticsHybridNormal(vec3 normal, float side)
{
  vec3 downhill = side * opticsNormalInEye(-g_opticsScalarGradient);
  return dot(normal, downhill) < 0.0 ? -normal : normal;
}
