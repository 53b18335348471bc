// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. No surface: the phase function alone.

struct OpticsSurface
{
  float coefficient;
};

OpticsSurface opticsSurface(float label)
{
  return OpticsSurface(0.0);
}

float opticsReflection(OpticsSurface surface, vec3 toLight)
{
  return 0.0;
}
