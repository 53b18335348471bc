// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. The ray between its samples. Places are counted in steps from VTK's first sample,
// which lies a step behind the entry; the ray begins and ends where the volume does.

float g_opticsPlace;    // of this sample
float g_opticsEnd;      // of the exit: the volume's, a clipping plane's, or opaque geometry
bool g_opticsWasHidden;  // the sample before this one
bool g_opticsHasFront;   // whether there is one and it has a scalar
float g_opticsFront;     // its scalar
float g_opticsFrontPlace;
vec3 g_opticsSeen;       // of this sample's segment: the first isosurface, or else its end
bool g_opticsSeesSurface;

vec4 opticsScalarsAt(vec3 texPosition)
{
  return texture(in_volume[0], texPosition) * in_volume_scale[0] + in_volume_bias[0];
}

// Front to back, without a limit to radiance. color: as classified, and the opacity to the eye.
void opticsComposite(vec4 color, vec4 scalars)
{
  g_opticsScalar = scalars;
  vec4 lit = computeLighting(color, 0, 0.0);
  lit.rgb *= lit.a;
  g_srcColor = lit;
  g_fragColor += (1.0 - g_fragColor.a) * lit;
}
