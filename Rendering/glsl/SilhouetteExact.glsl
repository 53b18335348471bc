// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after SilhouetteGeometry. [Kraus2005] eq. 15; post-classified eq. 18.

float opticsEyeOpacity(float attenuation, float extent, float steps)
{
  return attenuation > 0.0 ? SilhouetteOpacity(attenuation, extent, opticsGradientStep(steps)) : 0.0;
}

float opticsEyeSurfaceOpacity(float opacity)
{
  return SurfaceSilhouetteOpacity(opacity, opticsCosineToSurface());
}
