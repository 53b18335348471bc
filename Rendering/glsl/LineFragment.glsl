// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fragment shader of the atlas of evaluated voxels: each fragment is a voxel of a tile. Behind the formulas of Opacity,
// SphericalHarmonics, CylinderLighting and LineVoxel, and OPTICS_LINE_ORDER, _TYPES, _PRODUCT.

in vec2 texCoord;
uniform vec2 in_atlasSize;
uniform int in_tilesPerRow;
uniform int in_numberOfTiles;
uniform int in_numberOfPlaces; // voxels of all occupied bricks

uniform vec3 in_tileSize;
uniform vec3 in_brickSize;
uniform vec3 in_dimensions;
uniform vec3 in_voxelSize;
uniform vec3 in_eye; // from the corner of the first voxel
uniform vec3 in_toEye;
uniform int in_isParallel;

uniform sampler3D in_bricks;
uniform sampler2D in_tiles;
uniform isampler2D in_starts;
uniform usampler2D in_harmonics;
uniform sampler2D in_coefficients;
#if OPTICS_LINE_PRODUCT
uniform sampler2D in_products;
#endif

uniform vec3 in_scales[OPTICS_LINE_TYPES]; // of radius, of opacity, of the stored coefficients
uniform vec3 in_leastColors[OPTICS_LINE_TYPES];
uniform vec3 in_largestColors[OPTICS_LINE_TYPES];

uniform sampler1D in_opacityFunction;
uniform vec2 in_opacityFunctionCode;
uniform int in_mapsOpacity;

// Harmonics in the view direction, by l (l + 1) + m.
float g_basis[(OPTICS_LINE_ORDER + 1) * (OPTICS_LINE_ORDER + 1)];

void EvaluateBasis(vec3 direction)
{
  vec2 azimuth = vec2(ConstantHarmonic, 0.0);
  for (int m = 0; m <= OPTICS_LINE_ORDER; ++m)
  {
    azimuth = m > 0 ? SectoralFactor(m) * NextAzimuth(azimuth, direction) : azimuth;
    float value = 1.0;
    float before = 0.0;
    for (int l = m; l <= OPTICS_LINE_ORDER; ++l)
    {
      float next =
        l > m ? NextLegendre(value, before, direction.z, LegendreGain(l, m), LegendreLoss(l, m)) : 1.0;
      before = l > m ? value : 0.0;
      value = next;
      g_basis[l * (l + 1) - m] = value * azimuth.y;
      g_basis[l * (l + 1) + m] = value * azimuth.x;
    }
  }
}

ivec2 PlaceInRows(int index, int width)
{
  return ivec2(index % width, index / width);
}

vec3 ToEyeFrom(vec3 voxel)
{
  vec3 way = in_eye - (voxel + 0.5) * in_voxelSize;
  float distance = length(way);
  return in_isParallel == 1 || distance <= 0.0 ? in_toEye : way / distance;
}

// Colour times depth, depth, of one line type. place: of the voxel among those of the occupied bricks.
vec4 LinesOfType(int type, int place)
{
  int width = textureSize(in_starts, 0).x;
  int entry = type * in_numberOfPlaces + place;
  int first = texelFetch(in_starts, PlaceInRows(entry, width), 0).r;
  int end = texelFetch(in_starts, PlaceInRows(entry + 1, width), 0).r;
  int rows = textureSize(in_coefficients, 0).x;
  int harmonicRows = textureSize(in_harmonics, 0).x;
  vec4 sums = vec4(0.0);
  vec4 mean = vec4(0.0);
  float degree2 = 0.0;
  float product = 0.0;
  for (int i = first; i < end; ++i)
  {
    int harmonic = int(texelFetch(in_harmonics, PlaceInRows(i, harmonicRows), 0).r);
    vec4 part = g_basis[harmonic] * texelFetch(in_coefficients, PlaceInRows(i, rows), 0);
    sums += part;
    mean = harmonic == 0 ? part : mean;
    degree2 += harmonic >= 4 && harmonic < 9 ? part.a : 0.0;
#if OPTICS_LINE_PRODUCT
    product += g_basis[harmonic] *
      texelFetch(in_products, PlaceInRows(i, textureSize(in_products, 0).x), 0).r;
#endif
  }
  float scale = in_scales[type].z;
  float beyond = OPTICS_LINE_PRODUCT == 1 ? product - sums.a : 0.0;
  float depth = DepthOfLines(
    scale * sums.a, scale * beyond, scale * mean.a, scale * degree2, in_scales[type].x, in_scales[type].y);
  vec3 color = ColorOfLines(
    vec3(sums), sums.a, vec3(mean), max(mean.a, 1.0e-30), in_leastColors[type], in_largestColors[type]);
  return vec4(color * depth, depth);
}

// Colour times opacity, opacity.
vec4 EvaluatedVoxel(vec3 voxel)
{
  ivec3 brick = ivec3(voxel) / ivec3(in_brickSize);
  ivec3 inBrick = ivec3(voxel) - brick * ivec3(in_brickSize);
  int number = int(texelFetch(in_bricks, brick, 0).z);
  if (number < 0)
  {
    return vec4(0.0);
  }
  ivec3 size = ivec3(in_brickSize);
  int place = inBrick.x + size.x * (inBrick.y + size.y * (inBrick.z + size.z * number));
  EvaluateBasis(ToEyeFrom(voxel));
  vec4 lines = vec4(0.0);
  for (int type = 0; type < OPTICS_LINE_TYPES; ++type)
  {
    lines += LinesOfType(type, place);
  }
  float opacity = OneMinusExp(lines.a);
  float code = opacity * in_opacityFunctionCode.x + in_opacityFunctionCode.y;
  float drawn = in_mapsOpacity == 1 ? clamp(texture(in_opacityFunction, code).r, 0.0, 1.0) : opacity;
  return lines.a > 0.0 ? vec4(vec3(lines) / lines.a * drawn, drawn) : vec4(0.0);
}

void main()
{
  ivec2 texel = ivec2(texCoord * in_atlasSize);
  ivec3 tileSize = ivec3(in_tileSize);
  int tileWidth = tileSize.x * tileSize.z;
  int tile = texel.y / tileSize.y * in_tilesPerRow + texel.x / tileWidth;
  int across = texel.x % tileWidth;
  ivec3 inTile = ivec3(across % tileSize.x, texel.y % tileSize.y, across / tileSize.x);
  vec4 color = vec4(0.0);
  if (tile < in_numberOfTiles)
  {
    vec3 first = texelFetch(in_tiles, PlaceInRows(tile, textureSize(in_tiles, 0).x), 0).xyz;
    color = EvaluatedVoxel(min(first + vec3(inTile), in_dimensions - 1.0));
  }
  gl_FragData[0] = color;
}
