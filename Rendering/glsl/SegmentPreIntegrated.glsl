// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. A segment's colour and attenuation are those of all scalars from its front to
// its back, from a table of means.

uniform sampler2D in_opticsSegmentTable;  // mean colour, mean attenuation over the largest one
uniform float in_opticsSegmentTableSize;
uniform float in_opticsLargestAttenuation;

// Mean colour, and mean attenuation: per range of the scalar in data space, per unit distance otherwise.
vec4 opticsSegmentMean(float front, float back)
{
  vec4 mean = texture(in_opticsSegmentTable,
    vec2(TableCoordinate(front, in_opticsSegmentTableSize), TableCoordinate(back, in_opticsSegmentTableSize)));
  return vec4(mean.rgb, mean.a * in_opticsLargestAttenuation);
}

// What the end of a part of a segment is classified by.
float opticsClassified(float to, vec4 scalars)
{
  return to;
}
