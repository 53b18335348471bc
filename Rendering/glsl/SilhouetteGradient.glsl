// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after SilhouetteGeometry. [Kraus2005] eq. 18: the gradient's magnitude in place of
// its projection. A surface has no such form; it takes eq. 15.

float opticsEyeOpacity(float attenuation, float extent, float steps)
{
  return attenuation > 0.0 ? SegmentOpacity(attenuation, opticsGradientStep(steps)) : 0.0;
}

float opticsEyeSurfaceOpacity(float opacity)
{
  return SurfaceSilhouetteOpacity(opacity, opticsCosineToSurface());
}
