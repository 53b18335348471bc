// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. Looks anisotropic voxels up: interpolated between their middles, as they are beyond
// the outermost ones.

// Of LineAtlas.h.
const float OpticsLineBrick = 4.0;
const uint OpticsNoTile = 65535u;

// VTK's texture coordinates, or a way in them (w = 0), in voxels. Bricks are cells: VTK shifts nothing.
vec3 opticsTexToLines(vec4 texPosition)
{
  return vec3(in_opticsDataToLines * (in_textureDatasetMatrix[0] * texPosition));
}

bool opticsIsWithin(vec3 position, vec3 dimensions)
{
  return all(greaterThanEqual(position, vec3(0.0))) && all(lessThanEqual(position, dimensions));
}

// The brick whose tile holds the position.
vec3 opticsLineTile(vec3 position, vec3 dimensions)
{
  vec3 middles = clamp(position - 0.5, vec3(0.0), dimensions - 1.0);
  return min(floor(middles / OpticsLineBrick), ceil(dimensions / OpticsLineBrick) - 1.0);
}

// Colour, and optical depth over the length that the voxels' opacity belongs to. Colours are weighted by depth.
vec4 opticsLinesIn(usampler3D bricks, sampler2D atlas, vec3 position, vec3 dimensions)
{
  vec3 tile = opticsLineTile(position, dimensions);
  uvec2 corner = texelFetch(bricks, ivec3(tile), 0).rg;
  if (corner.x == OpticsNoTile || !opticsIsWithin(position, dimensions))
  {
    return vec4(0.0);
  }
  vec3 inTile = clamp(position - 0.5, vec3(0.0), dimensions - 1.0) - tile * OpticsLineBrick;
  float slice = min(floor(inTile.z), OpticsLineBrick - 1.0);
  vec2 texel = vec2(corner) + vec2(inTile) + vec2(slice * (OpticsLineBrick + 1.0), 0.0) + 0.5;
  vec2 scale = 1.0 / vec2(textureSize(atlas, 0));
  vec4 before = texture(atlas, texel * scale);
  vec4 behind = texture(atlas, (texel + vec2(OpticsLineBrick + 1.0, 0.0)) * scale);
  vec4 associated = mix(before, behind, inTile.z - slice);
  return vec4(vec3(associated) / max(associated.a, 1.0e-7), associated.a);
}

// Whole steps to the first place beyond the brick that holds the position, if nothing is drawn in it; otherwise 0.
// Both in voxels.
float opticsEmptyLineSteps(usampler3D bricks, vec3 position, vec3 direction, vec3 dimensions)
{
  vec3 tile = opticsLineTile(position, dimensions);
  vec3 last = ceil(dimensions / OpticsLineBrick) - 1.0;
  float steps = 1.0e6;
  for (int axis = 0; axis < 3; ++axis)
  {
    bool isUp = direction[axis] > 0.0;
    bool isOutermost = isUp ? tile[axis] >= last[axis] : tile[axis] <= 0.0;
    float face = (tile[axis] + (isUp ? 1.0 : 0.0)) * OpticsLineBrick + 0.5;
    if (direction[axis] != 0.0 && !isOutermost)
    {
      steps = min(steps, (face - position[axis]) / direction[axis]);
    }
  }
  bool isEmpty = texelFetch(bricks, ivec3(tile), 0).r == OpticsNoTile;
  return isEmpty ? max(ceil(steps), 1.0) : 0.0;
}
