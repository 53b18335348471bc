// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. What attenuation is per unit of: the length, in unit distances.

uniform float in_opticsUnitDistanceInverse;

float opticsExtent(float front, float back, float steps)
{
  return steps * in_sampleDistance * in_opticsUnitDistanceInverse;
}
