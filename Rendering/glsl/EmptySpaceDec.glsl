// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. Macrocells of the volume, and each one's distance, in cells, to the nearest with something to see.

uniform sampler3D in_opticsDistances;
uniform vec3 in_opticsMacrocells; // in the volume's texture, on each axis

// Samples from this one on that see nothing: none where this one may see something.
float opticsEmptySteps(vec3 texPosition, vec3 isForward, vec3 stepsPerCell)
{
  vec3 place = texPosition * in_opticsMacrocells;
  vec3 cell = floor(place);
  float near = 255.0 * texelFetch(in_opticsDistances, ivec3(cell), 0).r - 1.0;
  vec3 within = place - cell;
  vec3 steps = (mix(within, vec3(1.0) - within, isForward) + near) * stepsPerCell;
  return near > -0.5 ? floor(min(min(steps.x, steps.y), steps.z)) + 1.0 : 0.0;
}
