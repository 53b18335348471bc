// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. What attenuation is per unit of: the change of the scalar.

float opticsExtent(float front, float back, float steps)
{
  return abs(back - front);
}
