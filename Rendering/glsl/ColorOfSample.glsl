// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. Four dependent components: a colour and the scalar.

vec3 opticsColor(vec3 mean, vec4 scalars)
{
  return scalars.rgb;
}
