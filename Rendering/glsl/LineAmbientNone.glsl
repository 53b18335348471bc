// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. All light that was baked in arrives.
vec3 opticsLineLight(float opacity)
{
  return vec3(1.0);
}
