// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. Nothing asks for the colour function.

vec3 opticsTableColor(float scalar)
{
  return vec3(0.0);
}
