// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after SurfaceAnisotropic.

float opticsReflection(OpticsSurface surface, vec3 toLight)
{
  vec3 normal = opticsFacing(surface.normal, toLight);
  return LafortuneReflection(normal, surface.major, surface.minor, toLight, g_opticsToViewer, surface.majorParameter, in_opticsGlossiness);
}
