// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. The scalar in [0, 1] that opacity depends on.

float opticsScalarAt(vec3 texPosition)
{
  vec4 texel = texture(in_volume[0], texPosition) * in_volume_scale[0] + in_volume_bias[0];
  return dot(texel, in_opticsOpacityChannel);
}
