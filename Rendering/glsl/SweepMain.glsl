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

void main()
{
  vec2 place = in_sweepWindow.xy + gl_FragCoord.xy * in_sweepFroxel * in_sweepWindow.zw;
  opticsSweep(place, opticsFroxelOpacity(place));
}
