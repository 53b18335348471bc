// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. One component: the integral's own colour.

vec3 opticsColor(vec3 mean, vec4 scalars)
{
  return mean;
}
