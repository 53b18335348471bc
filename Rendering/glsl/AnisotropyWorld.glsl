// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after NormalLookup. Storage World.

uniform sampler3D in_opticsAnisotropy;
uniform sampler3D in_opticsAnisotropyMixed;

vec2 opticsAnisotropy(vec3 texPosition, vec3 normal)
{
  vec3 framePosition = (g_opticsTexToFrame * vec4(texPosition, 1.0)).xyz;
  WorldTensor tensor;
  tensor.diagonal = texture(in_opticsAnisotropy, framePosition).xyz * in_opticsFrameCode.x + in_opticsFrameCode.y;
  tensor.mixed = texture(in_opticsAnisotropyMixed, framePosition).xy * in_opticsFrameCode.x + in_opticsFrameCode.y;
  return DecodeWorld(normal, tensor);
}
