// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ScalarLookup. The scalars ahead and behind on the gradient, S1 and S2,
// by two fetches of the volume.

uniform mat3 in_opticsStepToVoxels; // a unit vector of data space to a step on the index axes

vec2 opticsScalarPair(vec3 texPosition, vec3 gradient)
{
  float steepness = length(gradient);
  vec3 direction = steepness > 0.0 ? gradient / steepness : vec3(0.0);
  vec3 offset = in_opticsStepToVoxels * direction / vec3(textureSize(in_volume[0], 0));
  return vec2(opticsScalarAt(texPosition + offset), opticsScalarAt(texPosition - offset));
}
