// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after Occlusion*. Ambient light where the sample is.

uniform vec3 in_opticsAmbientColor;

vec3 opticsAmbientLight(float opacity)
{
  return in_opticsAmbientColor * opticsOcclusion(g_dataPos, opacity);
}
