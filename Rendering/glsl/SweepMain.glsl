// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The visibility sweep's own main(), behind the ray caster's text.

uniform mat4 in_sweepToTexture; // view coordinates to VTK's texture coordinates
uniform mat4 in_sweepToWorld;   // and to world coordinates
uniform vec4 in_sweepWindow;    // least place, and the window's sides
uniform vec2 in_sweepFroxel;    // one over the number of froxels
uniform vec3 in_sweepDepths;    // z of this slice, of its front and of its back
uniform vec3 in_sweepWidths;    // and what makes a place x and y there

vec4 opticsPosition(vec2 place, int depth)
{
  return vec4(place * in_sweepWidths[depth], in_sweepDepths[depth], 1.0);
}

#ifdef OPTICS_SWEEP_OF_BLOCKS
uniform sampler3D in_sweepOpacity; // of the froxels of all slices, as SweepFill found it
uniform int in_sweepSlice;

float opticsFroxelOpacity(vec2 place)
{
  return texelFetch(in_sweepOpacity, ivec3(ivec2(gl_FragCoord.xy), in_sweepSlice), 0).r;
}
#else
// By the one step of castRay() that SweepRay* leaves.
float opticsFroxelOpacity(vec2 place)
{
  vec4 position = opticsPosition(place, 0);
  g_opticsFroxel = (in_sweepToTexture * position).xyz;
  g_opticsFroxelFront = (in_sweepToTexture * opticsPosition(place, 1)).xyz;
  g_opticsFroxelBack = (in_sweepToTexture * opticsPosition(place, 2)).xyz;
  bool isInside =
    all(greaterThanEqual(g_opticsFroxel, in_texMin[0])) && all(lessThanEqual(g_opticsFroxel, in_texMax[0]));
  bool isSeen = isInside && !opticsIsClipped((in_sweepToWorld * position).xyz);
  return isSeen ? clamp(castRay(-1.0, -1.0).a, 0.0, 1.0) : 0.0;
}
#endif

#ifdef OPTICS_SWEEP_GEOMETRY
uniform sampler2D in_sweepGeometry;   // depth of the opaque geometry that is nearest to the viewer
uniform vec3 in_sweepGeometryRange;   // z of depth 0 and of depth 1; 1 in perspective
uniform float in_sweepGeometryFront;  // least z that belongs to this slice

bool opticsHoldsGeometry()
{
  float depth = texture(in_sweepGeometry, gl_FragCoord.xy * in_sweepFroxel).r;
  float least = in_sweepGeometryRange.x;
  float largest = in_sweepGeometryRange.y;
  float z = in_sweepGeometryRange.z > 0.0 ? least * largest / mix(largest, least, depth) : mix(least, largest, depth);
  return z >= in_sweepGeometryFront && z < in_sweepDepths.z;
}
#else
bool opticsHoldsGeometry()
{
  return false;
}
#endif

void main()
{
  vec2 place = in_sweepWindow.xy + gl_FragCoord.xy * in_sweepFroxel * in_sweepWindow.zw;
  opticsSweep(place, opticsHoldsGeometry() ? 1.0 : opticsFroxelOpacity(place));
}
