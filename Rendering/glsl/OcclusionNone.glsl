// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. Ambient light is everywhere.

float opticsOcclusion(vec3 texPosition, float opacity)
{
  return 1.0;
}
