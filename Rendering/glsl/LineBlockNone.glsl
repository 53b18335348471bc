// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after LineLookup.

// What the lines show at a position, in voxels: colour, and extinction by length in data space.
vec4 opticsLinesAt(vec3 position)
{
  vec4 lines = opticsLinesIn(
    in_opticsLineBricks, in_opticsLineAtlas, position, in_opticsLineDimensions);
  return vec4(vec3(lines), lines.a * in_opticsLineUnitInverse);
}

float opticsStepsOverNothing(vec3 position, vec3 direction)
{
  return opticsEmptyLineSteps(
    in_opticsLineBricks, in_opticsLineCells, position, direction, in_opticsLineDimensions);
}
