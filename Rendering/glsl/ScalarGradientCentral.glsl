// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ScalarLookup. Gradient of the scalar in [0, 1] per step h, data space.

uniform mat3 in_opticsDifferenceToStep; // differences along the index axes to a gradient times h

vec3 g_opticsScalarGradient; // of the sample that is lit

// What a unit of each channel of the texture counts: the bias cancels out.
float opticsScalarDifference(vec3 texPosition, vec3 offset)
{
  vec4 difference = texture(in_volume[0], texPosition + offset) - texture(in_volume[0], texPosition - offset);
  return dot(difference, in_volume_scale[0] * in_opticsOpacityChannel);
}

vec3 opticsScalarGradient(vec3 texPosition)
{
  vec3 voxel = 1.0 / vec3(textureSize(in_volume[0], 0));
  return in_opticsDifferenceToStep *
    vec3(opticsScalarDifference(texPosition, vec3(voxel.x, 0.0, 0.0)),
      opticsScalarDifference(texPosition, vec3(0.0, voxel.y, 0.0)),
      opticsScalarDifference(texPosition, vec3(0.0, 0.0, voxel.z)));
}
