// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Physical space by a table of three dimensions, [Roettger2000]: front, back, length.

uniform sampler3D in_lengthTable;
uniform float in_scalarEntries;
uniform float in_lengthEntries;
uniform float in_largestLength;

vec4 FragmentColor(float front, float back, float segmentLength)
{
  return texture(in_lengthTable,
    vec3(TableCoordinate(front, in_scalarEntries), TableCoordinate(back, in_scalarEntries),
      TableCoordinate(segmentLength / in_largestLength, in_lengthEntries)));
}
