// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. The colour function.

uniform sampler1D in_opticsColorTable;
uniform vec2 in_opticsColorTableCode; // scale and bias to the centres of the first and last texel

vec3 opticsTableColor(float scalar)
{
  return texture(in_opticsColorTable, scalar * in_opticsColorTableCode.x + in_opticsColorTableCode.y).rgb;
}
