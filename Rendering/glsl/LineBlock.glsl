// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after LineLookup, in place of LineBlockNone. A block of other voxels replaces those in
// its box.

uniform usampler3D in_opticsBlockBricks;
uniform usampler2D in_opticsBlockCells;
uniform sampler2D in_opticsBlockAtlas;
uniform mat4 in_opticsLinesToBlock;
uniform vec3 in_opticsBlockDimensions;
uniform float in_opticsBlockUnitInverse;

// What the lines show at a position, in voxels: colour, and extinction by length in data space.
vec4 opticsLinesAt(vec3 position)
{
  vec3 inBlock = vec3(in_opticsLinesToBlock * vec4(position, 1.0));
  if (opticsIsWithin(inBlock, in_opticsBlockDimensions))
  {
    vec4 lines = opticsLinesIn(
      in_opticsBlockBricks, in_opticsBlockAtlas, inBlock, in_opticsBlockDimensions);
    return vec4(vec3(lines), lines.a * in_opticsBlockUnitInverse);
  }
  vec4 lines = opticsLinesIn(
    in_opticsLineBricks, in_opticsLineAtlas, position, in_opticsLineDimensions);
  return vec4(vec3(lines), lines.a * in_opticsLineUnitInverse);
}

// Steps to where the way enters the block, and to where it leaves it.
vec2 opticsStepsToBlock(vec3 position, vec3 direction)
{
  vec2 steps = vec2(0.0, 1.0e6);
  for (int axis = 0; axis < 3; ++axis)
  {
    float first = -position[axis] / direction[axis];
    float second = (in_opticsBlockDimensions[axis] - position[axis]) / direction[axis];
    bool isOutside = position[axis] < 0.0 || position[axis] > in_opticsBlockDimensions[axis];
    vec2 alongFaces = isOutside ? vec2(1.0e6, 0.0) : vec2(0.0, 1.0e6);
    vec2 crossed = direction[axis] == 0.0 ? alongFaces : vec2(min(first, second), max(first, second));
    steps = vec2(max(steps.x, crossed.x), min(steps.y, crossed.y));
  }
  return steps;
}

float opticsStepsOverNothing(vec3 position, vec3 direction)
{
  vec3 inBlock = vec3(in_opticsLinesToBlock * vec4(position, 1.0));
  vec3 wayInBlock = vec3(in_opticsLinesToBlock * vec4(direction, 0.0));
  vec2 steps = opticsStepsToBlock(inBlock, wayInBlock);
  bool isWithin = opticsIsWithin(inBlock, in_opticsBlockDimensions);
  float ofBlock = opticsEmptyLineSteps(
    in_opticsBlockBricks, in_opticsBlockCells, inBlock, wayInBlock, in_opticsBlockDimensions);
  float ofLines = opticsEmptyLineSteps(
    in_opticsLineBricks, in_opticsLineCells, position, direction, in_opticsLineDimensions);
  float toFace = max(isWithin ? ceil(steps.y) : (steps.x <= steps.y ? ceil(steps.x) : 1.0e6), 1.0);
  return min(isWithin ? ofBlock : ofLines, toFace);
}
