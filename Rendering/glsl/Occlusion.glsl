// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OwnOpacity*. Fractional visibility: what reaches the slice in front, as the sweep
// from the eye found it, and what the ray itself has met since. A slice's own opacity would show its distance as rings
// on every dense surface; the ray knows where in the slice the surface begins.

uniform sampler3D in_opticsOcclusion;
uniform mat4 in_opticsOcclusionGrid;  // VTK's texture coordinates to (x w, y w, z, w) of the grid's
uniform vec3 in_opticsOcclusionNumbers; // of slices; MeanWayOut() of the cone; 1, or 0: nothing is known

vec3 g_opticsOwnDepth = vec3(0.0); // of opticsOwnDepth(): three parts of a sum
float g_opticsOwnPlace = 0.0;      // where it was taken, in slices
float g_opticsClear = 1.0;         // transmittance of the ray up to there

// Optical depth of the ray since the slice in front: of what lies s slices back exp(-x) (1 + x + x^2/2) counts,
// x = 3 s, which is nearly 1 to half a slice and 1 over all s. Each step back takes an older part to the next power.
float opticsOwnDepth(float place)
{
  float clear = max(1.0 - g_fragColor.a, 1.0e-6);
  vec3 own = g_opticsOwnDepth;
  own.x += log(max(g_opticsClear / clear, 1.0));
  float x = 3.0 * abs(place - g_opticsOwnPlace);
  g_opticsOwnDepth = exp(-x) * vec3(own.x, own.y + x * own.x, own.z + x * (own.y + 0.5 * x * own.x));
  g_opticsOwnPlace = place;
  g_opticsClear = clear;
  return g_opticsOwnDepth.x + g_opticsOwnDepth.y + g_opticsOwnDepth.z;
}

float opticsOcclusion(vec3 texPosition, float opacity)
{
#ifdef OPTICS_SWEEP
  return 1.0; // what is drawn on must not be read
#else
  vec4 froxel = in_opticsOcclusionGrid * vec4(texPosition, 1.0);
  float reaching = texture(in_opticsOcclusion, vec3(froxel.xy / froxel.w, froxel.z)).r;
  float ownDepth = opticsOwnDepth(froxel.z * in_opticsOcclusionNumbers.x);
  float wayOut = in_opticsOcclusionNumbers.y;
  float own = exp(-ownDepth * wayOut) * StretchVisibility(opticsOwnOpacity(opacity), wayOut);
  return in_opticsOcclusionNumbers.z > 0.0 ? reaching * own : 1.0;
#endif
}
