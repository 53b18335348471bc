// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after NormalLookup. Gradient of the scalar in [0, 1] per step h, data space.

vec3 g_opticsScalarGradient; // of the sample that is lit

vec3 opticsScalarGradient(vec3 texPosition)
{
  OpticsNormal stored = opticsStoredNormal(texPosition);
  return stored.normal * -stored.change;
}
