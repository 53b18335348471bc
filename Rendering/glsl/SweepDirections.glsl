// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::Output::Dec

// Behind the ray caster's text, after Visibility. Some fixed directions of the cone, one channel each: what reaches this
// slice, from where the direction crosses the one before it, and what of it passes this one. Outside of the
// window it is as at its edge.

uniform vec2 in_sweepSlopes[16];
uniform float in_sweepLengths[16]; // of the way from slice to slice, relative to their distance
uniform float in_sweepSliceDistance;
uniform float in_sweepWidth;       // of this slice
uniform float in_sweepOtherWidth;  // of the one before it
uniform vec4 in_sweepWindowCode;   // scale and bias from places to texture coordinates

#ifdef OPTICS_SWEEP_ABOUT_EYE
// The cone's axis is the direction to the eye: another one at each place, so that rays bend a little.
uniform mat3 in_sweepToSlices; // a slope (x, y, -1) to the way from slice to slice, relative to their distance

vec2 opticsSlope(int index, vec2 place)
{
  return SlopeOfWay(TurnToAxis(vec3(in_sweepSlopes[index], -1.0), -normalize(vec3(place, 1.0))));
}

float opticsLength(int index, vec2 slope)
{
  return length(in_sweepToSlices * vec3(slope, -1.0));
}
#elif defined(OPTICS_SWEEP_TO_VIEWER)
// Each direction ends in one point of a disk at the viewer.
uniform mat3 in_sweepToSlices;        // a slope (x, y, -1) to the way from slice to slice, relative to their distance
uniform float in_sweepViewerDistance; // from which the disk appears under the angle of the cone

vec2 opticsSlope(int index, vec2 place)
{
  return in_sweepSlopes[index] * (in_sweepViewerDistance / in_sweepWidth) - place;
}

float opticsLength(int index, vec2 slope)
{
  return length(in_sweepToSlices * vec3(slope, -1.0));
}
#else
vec2 opticsSlope(int index, vec2 place)
{
  return in_sweepSlopes[index];
}

float opticsLength(int index, vec2 slope)
{
  return in_sweepLengths[index];
}
#endif

float g_sweepReaching = 0.0;
vec4 g_sweepMiddle; // what reaches the middle of the slice, by each of the last four directions

vec4 opticsSweepFour(sampler2D passed, int first, vec2 place, float opacity)
{
  vec4 passing = vec4(0.0);
  for (int i = 0; i < min(4, OPTICS_SWEEP_DIRECTIONS); ++i)
  {
    vec2 slope = opticsSlope(first + i, place);
    vec2 before = PlaceOnSlice(place, slope, in_sweepSliceDistance, in_sweepWidth, in_sweepOtherWidth);
    float reaching = texture(passed, before * in_sweepWindowCode.xy + in_sweepWindowCode.zw)[i];
    g_sweepReaching += reaching;
    passing[i] = reaching * StretchTransmittance(opacity, opticsRelativeLength(opticsLength(first + i, slope)));
    g_sweepMiddle[i] = sqrt(reaching * passing[i]);
  }
  return passing;
}

uniform sampler2D in_sweepPassed0;
#if OPTICS_SWEEP_DIRECTIONS > 4
uniform sampler2D in_sweepPassed1;
#endif
#if OPTICS_SWEEP_DIRECTIONS > 8
uniform sampler2D in_sweepPassed2;
uniform sampler2D in_sweepPassed3;
#endif

// Odd outputs are what passes the slice, even ones the slice's layers: one for four directions, or one for their mean.
#ifdef OPTICS_SWEEP_BY_DIRECTION
#define OPTICS_SWEEP_KEEP(layer) layer = g_sweepMiddle
#else
#define OPTICS_SWEEP_KEEP(layer)
#endif

void opticsSweep(vec2 place, float opacity)
{
  gl_FragData[1] = opticsSweepFour(in_sweepPassed0, 0, place, opacity);
  OPTICS_SWEEP_KEEP(gl_FragData[0]);
#if OPTICS_SWEEP_DIRECTIONS > 4
  gl_FragData[3] = opticsSweepFour(in_sweepPassed1, 4, place, opacity);
  OPTICS_SWEEP_KEEP(gl_FragData[2]);
#endif
#if OPTICS_SWEEP_DIRECTIONS > 8
  gl_FragData[5] = opticsSweepFour(in_sweepPassed2, 8, place, opacity);
  OPTICS_SWEEP_KEEP(gl_FragData[4]);
  gl_FragData[7] = opticsSweepFour(in_sweepPassed3, 12, place, opacity);
  OPTICS_SWEEP_KEEP(gl_FragData[6]);
#endif
#ifndef OPTICS_SWEEP_BY_DIRECTION
  gl_FragData[0] = vec4(g_sweepReaching / float(OPTICS_SWEEP_DIRECTIONS));
#endif
}
