// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after ColorTable. A segment is classified by the scalar at its back.

uniform float in_opticsUnitsPerRange; // unit intervals of data in the range of the scalars

// Mean colour, and mean attenuation per range of the scalar.
vec4 opticsSegmentMean(float front, float back)
{
  float opacity = opticsTableOpacity(back);
  float depth = opacity < 1.0 ? OpticalDepth(opacity) : OpaqueDepth;
  return vec4(opticsTableColor(back), depth * in_opticsUnitsPerRange);
}

// What the end of a part of a segment is classified by: the segment's own end.
float opticsClassified(float to, vec4 scalars)
{
  return dot(scalars, in_opticsOpacityChannel);
}
