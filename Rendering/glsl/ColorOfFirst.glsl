// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after ColorTable. Two dependent components: the first one has the colour.

vec3 opticsColor(vec3 mean, vec4 scalars)
{
  return opticsTableColor(scalars.x);
}
