// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ScalarLookup. Gradient of the scalar in [0, 1] per step h, data space.

uniform mat3 in_opticsDifferenceToStep; // differences along the index axes to a gradient times h

vec3 opticsScalarGradient(vec3 texPosition)
{
  vec3 voxel = 1.0 / vec3(textureSize(in_volume[0], 0));
  vec3 x = vec3(voxel.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxel.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxel.z);
  vec3 ahead = vec3(opticsScalarAt(texPosition + x), opticsScalarAt(texPosition + y), opticsScalarAt(texPosition + z));
  vec3 behind = vec3(opticsScalarAt(texPosition - x), opticsScalarAt(texPosition - y), opticsScalarAt(texPosition - z));
  return in_opticsDifferenceToStep * (ahead - behind);
}
