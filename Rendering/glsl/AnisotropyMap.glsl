// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after NormalLookup. Storage Map.

uniform sampler3D in_opticsAnisotropy;

vec2 opticsAnisotropy(vec3 texPosition, vec3 normal)
{
  vec3 framePosition = (g_opticsTexToFrame * vec4(texPosition, 1.0)).xyz;
  return DecodeMap(normal, texture(in_opticsAnisotropy, framePosition).xyz * in_opticsFrameCode.x + in_opticsFrameCode.y);
}
