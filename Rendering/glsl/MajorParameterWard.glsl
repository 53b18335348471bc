// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, before SurfaceAnisotropic.

uniform float in_opticsAnisotropyScale;

float opticsMajorParameter(float logRatio)
{
  return WardMajorRoughness(in_opticsGlossiness, logRatio, in_opticsAnisotropyScale);
}
