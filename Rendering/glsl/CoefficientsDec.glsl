// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec.

struct OpticsCoefficients
{
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
};
