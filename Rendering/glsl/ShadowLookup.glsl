// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OwnDepth. What of a light passes the volume and other things on its way to the
// sample: what reaches the slice in front of it, and, as for Occlusion, what the ray itself has met since. A light has
// one view of the volume or several, each with a grid in the atlas.

uniform sampler3D in_opticsShadows;
uniform mat4 in_opticsShadowView[OPTICS_SHADOW_VIEWS];   // to (x w, y w, z, w), each of x, y, z from 0 to 1
uniform vec3 in_opticsShadowFirst[OPTICS_SHADOW_VIEWS];  // texel of the atlas
uniform vec3 in_opticsShadowSize[OPTICS_SHADOW_VIEWS];   // texels
uniform vec3 in_opticsShadowOfLight[OPTICS_LIGHT_SLOTS]; // first view, the one behind the last, attenuation
uniform mat3 in_opticsShadowToSlices;                    // a way in VTK's texture coordinates, to slices of the lights

// A border that rounding has moved still belongs to the view.
const float opticsViewTolerance = 1.0e-3;

OpticsOwnDepth g_opticsShadowDepth = opticsNothingMet;
vec3 g_opticsShadowPlace = vec3(0.0); // where it was taken

// The way to the light is taken to be as long as the ray's: which it is, is known of surfaces with a normal alone.
float opticsShadowOwn(float opacity)
{
  g_opticsShadowDepth = opticsMeet(g_opticsShadowDepth, length(in_opticsShadowToSlices * (g_dataPos - g_opticsShadowPlace)));
  g_opticsShadowPlace = g_dataPos;
  return opticsOwnVisibility(g_opticsShadowDepth, opacity, 1.0);
}

float opticsShadow(int index, float own)
{
#ifdef OPTICS_SWEEP
  return 1.0; // a sweep has no light
#else
  vec3 shadow = in_opticsShadowOfLight[index];
  for (int i = int(shadow.x); i < int(shadow.y); ++i)
  {
    vec4 seen = in_opticsShadowView[i] * vec4(g_dataPos, 1.0);
    vec2 side = abs(seen.xy - 0.5 * seen.w);
    if (seen.w > 0.0 && max(side.x, side.y) <= (0.5 + opticsViewTolerance) * seen.w)
    {
      vec3 size = in_opticsShadowSize[i];
      vec3 texel = clamp(vec3(seen.xy / seen.w, seen.z) * size, vec3(0.5), size - 0.5);
      vec3 coordinates = (in_opticsShadowFirst[i] + texel) / vec3(textureSize(in_opticsShadows, 0));
      return mix(1.0, own * texture(in_opticsShadows, coordinates).r, shadow.z);
    }
  }
  return 1.0;
#endif
}
