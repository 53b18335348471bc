// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after Reflectance*. The diffuse part is a phase function.

uniform float in_opticsScatteringAnisotropy;

float opticsScattering(OpticsSurface surface, vec3 toLight)
{
  return HenyeyGreenstein(in_opticsScatteringAnisotropy, -dot(toLight, g_opticsToViewer));
}
