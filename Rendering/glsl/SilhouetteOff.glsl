// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. Opacity along the ray as it is.

float opticsEyeOpacity(float attenuation, float extent, float steps)
{
  return SegmentOpacity(attenuation, extent);
}

float opticsEyeSurfaceOpacity(float opacity)
{
  return opacity;
}
