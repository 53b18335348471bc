// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OwnOpacity*. Fractional visibility: what reaches the slice in front, as the sweep
// from the eye found it, and what the ray itself has met since. A slice's own opacity would show its distance as rings
// on every dense surface; the ray knows where in the slice the surface begins.

uniform sampler3D in_opticsOcclusion;
uniform mat4 in_opticsOcclusionGrid;  // VTK's texture coordinates to (x w, y w, z, w) of the grid's
uniform vec3 in_opticsOcclusionNumbers; // of slices; one over the mean cosine of the cone; 1, or 0: nothing is known

float g_opticsOwnDepth = 0.0; // optical depth along the ray, fading over a slice
float g_opticsOwnPlace = 0.0; // where it was taken, in slices
float g_opticsClear = 1.0;    // transmittance of the ray up to there

// After the samples in front of this one.
float opticsOwnDepth(float place)
{
  float clear = max(1.0 - g_fragColor.a, 1.0e-6);
  float met = log(max(g_opticsClear / clear, 1.0));
  g_opticsOwnDepth = (g_opticsOwnDepth + met) * exp(-abs(place - g_opticsOwnPlace));
  g_opticsOwnPlace = place;
  g_opticsClear = clear;
  return g_opticsOwnDepth;
}

float opticsOcclusion(vec3 texPosition, float opacity)
{
#ifdef OPTICS_SWEEP
  return 1.0; // what is drawn on must not be read
#else
  vec4 froxel = in_opticsOcclusionGrid * vec4(texPosition, 1.0);
  float reaching = texture(in_opticsOcclusion, vec3(froxel.xy / froxel.w, froxel.z)).r;
  float ownDepth = opticsOwnDepth(froxel.z * in_opticsOcclusionNumbers.x);
  float cosineInverse = in_opticsOcclusionNumbers.y;
  float own = exp(-ownDepth * cosineInverse) * StretchVisibility(opticsOwnOpacity(opacity), cosineInverse);
  return in_opticsOcclusionNumbers.z > 0.0 ? reaching * own : 1.0;
#endif
}
