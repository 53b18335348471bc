// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ScalarGradient* and ScalarPair*. Coefficients by the lighting transfer
// function, whose table's coordinates are S1 and S2.

uniform sampler2D in_opticsLightingTable;
uniform vec2 in_opticsLightingTableCode; // scale and bias of the fourth, signed channel
uniform float in_opticsLightScale;

float g_opticsDensityDifference; // of the last sample

OpticsCoefficients opticsCoefficients(int component)
{
  vec4 texel = texture(in_opticsLightingTable, opticsScalarPair(g_dataPos, g_opticsScalarGradient));
  g_opticsDensityDifference = texel.a * in_opticsLightingTableCode.x + in_opticsLightingTableCode.y;
  vec3 coefficients = texel.rgb * in_opticsLightScale;
  return OpticsCoefficients(vec3(coefficients.r), vec3(coefficients.g), vec3(coefficients.b));
}
