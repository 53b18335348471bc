// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. Opacity per ScalarOpacityUnitDistance, before any correction for the step.

uniform sampler1D in_opticsOpacityTable;
uniform vec2 in_opticsOpacityTableCode; // scale and bias to the centres of the first and last texel

float opticsTableOpacity(float scalar)
{
  return texture(in_opticsOpacityTable, scalar * in_opticsOpacityTableCode.x + in_opticsOpacityTableCode.y).r;
}
