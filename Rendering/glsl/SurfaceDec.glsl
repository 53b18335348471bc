// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. A surface has a normal.

uniform float in_opticsTwoSided; // 0 or 1

vec3 opticsNormalInEye(vec3 normal)
{
  vec3 inEye = in_opticsNormalToEye * normal;
  float squared = dot(inEye, inEye);
  return squared > 0.0 ? inEye * inversesqrt(squared) : vec3(0.0);
}

// Two-sided lighting: the side that the light falls on is the front.
vec3 opticsFacing(vec3 normal, vec3 toLight)
{
  return dot(normal, toLight) < 0.0 ? normal * (1.0 - 2.0 * in_opticsTwoSided) : normal;
}
