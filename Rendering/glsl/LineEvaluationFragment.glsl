// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fragment shader of the list of evaluated voxels: a fragment is a voxel. Behind the formulas of Opacity,
// SphericalHarmonics, CylinderLighting and LineVoxel, and OPTICS_LINE_ORDER, _TYPES.

uniform int in_numberOfVoxels;
uniform vec3 in_voxelSize;
uniform vec3 in_eye; // from the corner of the first voxel
uniform vec3 in_toEye;
uniform int in_isParallel;

uniform usampler2D in_voxels;
uniform isampler2D in_starts;
uniform usampler2D in_harmonics;
uniform sampler2D in_coefficients;

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

// Of a voxel's harmonics in the view direction: all, degree 0 (means over all directions), degree 2 of the depth.
struct LineSums
{
  vec4 Whole;
  vec4 Mean;
  float Degree2;
};

#ifdef OPTICS_LINE_BYTES
// Bytes are shares of the voxel's range; degree 0 is stored beside it.
uniform sampler2D in_ranges;

LineSums Decoded(LineSums stored, int entry)
{
  int width = textureSize(in_ranges, 0).x;
  vec4 mean = g_basis[0] * texelFetch(in_ranges, PlaceInRows(2 * entry, width), 0);
  vec4 range = texelFetch(in_ranges, PlaceInRows(2 * entry + 1, width), 0);
  return LineSums(mean + range * stored.Whole, mean, range.a * stored.Degree2);
}
#else
LineSums Decoded(LineSums stored, int entry)
{
  return stored;
}
#endif

// Colour times depth, depth, of one line type in a voxel.
vec4 LinesOfType(int type, int voxel)
{
  int width = textureSize(in_starts, 0).x;
  int entry = type * in_numberOfVoxels + voxel;
  int first = texelFetch(in_starts, PlaceInRows(entry, width), 0).r;
  int end = texelFetch(in_starts, PlaceInRows(entry + 1, width), 0).r;
  int rows = textureSize(in_coefficients, 0).x;
  int harmonicRows = textureSize(in_harmonics, 0).x;
  LineSums stored = LineSums(vec4(0.0), vec4(0.0), 0.0);
  for (int i = first; i < end; ++i)
  {
    int harmonic = int(texelFetch(in_harmonics, PlaceInRows(i, harmonicRows), 0).r);
    vec4 part = g_basis[harmonic] * texelFetch(in_coefficients, PlaceInRows(i, rows), 0);
    stored.Whole += part;
    stored.Mean = harmonic == 0 ? part : stored.Mean;
    stored.Degree2 += harmonic >= 4 && harmonic < 9 ? part.a : 0.0;
  }
  LineSums sums = Decoded(stored, entry);
  float scale = in_scales[type].z;
  float depth = DepthOfLines(scale * sums.Whole.a, scale * sums.Mean.a, scale * sums.Degree2,
    in_scales[type].x, in_scales[type].y);
  vec3 color = ColorOfLines(vec3(sums.Whole), sums.Whole.a, vec3(sums.Mean), max(sums.Mean.a, 1.0e-30),
    in_leastColors[type], in_largestColors[type]);
  return vec4(color * depth, depth);
}

// Colour times optical depth, optical depth: what may be interpolated without a loss of extinction.
vec4 EvaluatedVoxel(int voxel)
{
  uvec4 place = texelFetch(in_voxels, PlaceInRows(voxel, textureSize(in_voxels, 0).x), 0);
  EvaluateBasis(ToEyeFrom(vec3(place)));
  vec4 lines = vec4(0.0);
  for (int type = 0; type < OPTICS_LINE_TYPES; ++type)
  {
    lines += LinesOfType(type, voxel);
  }
  float opacity = OneMinusExp(lines.a);
  float code = opacity * in_opacityFunctionCode.x + in_opacityFunctionCode.y;
  float mapped = clamp(textureLod(in_opacityFunction, code, 0.0).r, 0.0, 1.0);
  float drawn = min(in_mapsOpacity == 1 ? OpticalDepth(mapped) : lines.a, LargestLineDepth);
  return lines.a > 0.0 ? vec4(vec3(lines) / lines.a * drawn, drawn) : vec4(0.0);
}

void main()
{
  int voxel = int(gl_FragCoord.x) + textureSize(in_voxels, 0).x * int(gl_FragCoord.y);
  gl_FragData[0] = voxel < in_numberOfVoxels ? EvaluatedVoxel(voxel) : vec4(0.0);
}
