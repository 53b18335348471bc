// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OwnDepth. Fractional visibility: what reaches the slice in front, as the sweep
// from the eye found it, and what the ray itself has met since.

uniform sampler3D in_opticsOcclusion;
uniform mat4 in_opticsOcclusionGrid;  // VTK's texture coordinates to (x w, y w, z, w) of the grid's
uniform vec3 in_opticsOcclusionNumbers; // of slices; MeanWayOut() of the cone; 1, or 0: nothing is known

OpticsOwnDepth g_opticsOwnDepth = opticsNothingMet;
float g_opticsOwnPlace = 0.0; // where it was taken, in slices

float opticsOcclusion(vec3 texPosition, float opacity)
{
#ifdef OPTICS_SWEEP
  return 1.0; // what is drawn on must not be read
#else
  vec4 froxel = in_opticsOcclusionGrid * vec4(texPosition, 1.0);
  float reaching = texture(in_opticsOcclusion, vec3(froxel.xy / froxel.w, froxel.z)).r;
  float place = froxel.z * in_opticsOcclusionNumbers.x;
  g_opticsOwnDepth = opticsMeet(g_opticsOwnDepth, abs(place - g_opticsOwnPlace));
  g_opticsOwnPlace = place;
  float own = opticsOwnVisibility(g_opticsOwnDepth, opacity, in_opticsOcclusionNumbers.y);
  return in_opticsOcclusionNumbers.z > 0.0 ? reaching * own : 1.0;
#endif
}
