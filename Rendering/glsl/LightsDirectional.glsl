// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. Every light has one direction.

uniform vec3 in_opticsLightDiffuse[OPTICS_LIGHT_SLOTS];
uniform vec3 in_opticsLightSpecular[OPTICS_LIGHT_SLOTS];
uniform vec3 in_opticsLightDirection[OPTICS_LIGHT_SLOTS]; // eye space, unit, of travel

struct OpticsLight
{
  vec3 toLight;
  float attenuation;
};

OpticsLight opticsLight(int index)
{
  return OpticsLight(-in_opticsLightDirection[index], 1.0);
}
