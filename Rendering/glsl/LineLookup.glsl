// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. Looks anisotropic voxels up: interpolated between their middles, as they are beyond
// the outermost ones.

// Of LineAtlas.h.
const float OpticsLineBrick = 4.0;
const uint OpticsNoTile = 65535u;
const uvec2 OpticsLineTile = uvec2(25u, 5u); // texels of a tile

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

// Faces of a box around the position in which nothing is drawn, in voxels between whose middles all is interpolated: of a
// cell between eight of them, or of all bricks around that are nearer than the next one with a tile. Without volume
// where something may be drawn.
struct OpticsEmptyBox
{
  vec3 First;
  vec3 Last;
};

OpticsEmptyBox opticsEmptyLineBox(
  usampler3D bricks, usampler2D cells, vec3 position, vec3 dimensions)
{
  vec3 tile = opticsLineTile(position, dimensions);
  uvec2 corner = texelFetch(bricks, ivec3(tile), 0).rg;
  if (corner.x == OpticsNoTile)
  {
    float reach = float(corner.y);
    return OpticsEmptyBox((tile - reach + 1.0) * OpticsLineBrick, (tile + reach) * OpticsLineBrick);
  }
  vec3 cell = floor(clamp(position - 0.5, vec3(0.0), dimensions - 1.0));
  uvec3 inTile = uvec3(min(cell - tile * OpticsLineBrick, vec3(OpticsLineBrick - 1.0)));
  uvec2 occupied = texelFetch(cells, ivec2(corner / OpticsLineTile), 0).rg;
  uint bits = (inTile.z < 2u ? occupied.x : occupied.y) >> (inTile.x + 4u * inTile.y + 16u * (inTile.z & 1u));
  return OpticsEmptyBox(cell, cell + (1.0 - float(bits & 1u)));
}

// Whole steps to the first place beyond what is empty around the position; 0 where something may be drawn. Both in voxels.
float opticsEmptyLineSteps(
  usampler3D bricks, usampler2D cells, vec3 position, vec3 direction, vec3 dimensions)
{
  OpticsEmptyBox box = opticsEmptyLineBox(bricks, cells, position, dimensions);
  float steps = 1.0e6;
  for (int axis = 0; axis < 3; ++axis)
  {
    bool isUp = direction[axis] > 0.0;
    bool isOutermost = isUp ? box.Last[axis] > dimensions[axis] - 1.0 : box.First[axis] <= 0.0;
    float face = (isUp ? box.Last[axis] : box.First[axis]) + 0.5;
    if (direction[axis] != 0.0 && !isOutermost)
    {
      steps = min(steps, (face - position[axis]) / direction[axis]);
    }
  }
  return box.Last.x > box.First.x ? max(ceil(steps), 1.0) : 0.0;
}
