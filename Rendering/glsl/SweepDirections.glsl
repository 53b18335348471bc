// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::Output::Dec

// Behind the ray caster's text, after Visibility. Some fixed directions of the cone, one channel each: what reaches this
// slice, from where the direction crosses the one before it, and what of it passes this one. Whatever comes from outside
// of the window has met nothing.

uniform vec2 in_sweepSlopes[16];
uniform float in_sweepLengths[16]; // of the way from slice to slice, relative to their distance
uniform float in_sweepSliceDistance;
uniform float in_sweepWidth;       // of this slice
uniform float in_sweepOtherWidth;  // of the one before it
uniform vec4 in_sweepWindowCode;   // scale and bias from places to texture coordinates

float g_sweepReaching = 0.0;

vec4 opticsSweepFour(sampler2D passed, int first, vec2 place, float opacity)
{
  vec4 passing = vec4(0.0);
  for (int i = 0; i < min(4, OPTICS_SWEEP_DIRECTIONS); ++i)
  {
    vec2 before = PlaceOnSlice(
      place, in_sweepSlopes[first + i], in_sweepSliceDistance, in_sweepWidth, in_sweepOtherWidth);
    float reaching = texture(passed, before * in_sweepWindowCode.xy + in_sweepWindowCode.zw)[i];
    g_sweepReaching += reaching;
    passing[i] = reaching * StretchTransmittance(opacity, opticsRelativeLength(in_sweepLengths[first + i]));
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

void opticsSweep(vec2 place, float opacity)
{
  gl_FragData[1] = opticsSweepFour(in_sweepPassed0, 0, place, opacity);
#if OPTICS_SWEEP_DIRECTIONS > 4
  gl_FragData[2] = opticsSweepFour(in_sweepPassed1, 4, place, opacity);
#endif
#if OPTICS_SWEEP_DIRECTIONS > 8
  gl_FragData[3] = opticsSweepFour(in_sweepPassed2, 8, place, opacity);
  gl_FragData[4] = opticsSweepFour(in_sweepPassed3, 12, place, opacity);
#endif
  gl_FragData[0] = vec4(g_sweepReaching / float(OPTICS_SWEEP_DIRECTIONS));
}
