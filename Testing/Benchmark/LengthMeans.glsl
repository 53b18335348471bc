// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Physical space by means: the opacity is exact for every length, which makes it the truth for a table.

uniform sampler2D in_meanTable;
uniform float in_scalarEntries;
uniform float in_unitDistance;

vec4 FragmentColor(float front, float back, float segmentLength)
{
  vec2 place = vec2(TableCoordinate(front, in_scalarEntries), TableCoordinate(back, in_scalarEntries));
  vec4 mean = texture(in_meanTable, place);
  float opacity = SegmentOpacity(mean.w, segmentLength / in_unitDistance);
  return vec4(vec3(mean) * opacity, opacity);
}
