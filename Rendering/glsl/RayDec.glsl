// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. Spaces: eye space for light, data space (VTK's "dataset") for the frame.

uniform mat3 in_opticsTangentToEye; // data to eye, for directions
uniform mat3 in_opticsNormalToEye;  // its inverse transposed, for normals

vec3 g_opticsToViewer;   // eye space, unit, constant along the ray
float g_opticsEyePerData; // length in eye space of the unit of data space, along the ray
mat4 g_opticsTexToEye;   // VTK's texture coordinates of this block to eye space

// VTK clamps each sample's radiance to [0, 1]; a highlight on a translucent sample needs more.
vec4 opticsUnclamped(vec4 radiance, float unusedLeast, float unusedLargest)
{
  return radiance;
}
