// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the lines show at a position, in voxels: colour, and extinction by length in data space.
vec4 opticsLinesAt(vec3 position)
{
  vec4 lines = opticsLinesIn(
    in_opticsLineBricks, in_opticsLineAtlas, position, in_opticsLineDimensions, in_opticsLineBrick);
  return vec4(vec3(lines), lines.a * in_opticsLineUnitInverse);
}

// Whether nothing is drawn at a position.
bool opticsLinesAreEmptyAt(vec3 position)
{
  vec3 tile = opticsLineTile(position, in_opticsLineDimensions, in_opticsLineBrick);
  return texelFetch(in_opticsLineBricks, ivec3(tile), 0).x < 0.0;
}
