// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. Of light that was baked in, as much arrives as of ambient light. opacity: of the
// sample.
vec3 opticsLineLight(float opacity)
{
  return opticsAmbientLight(opacity);
}
