// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after LineAmbient*. The light of all lights is baked in as one: what arrives of it is
// the mean of what arrives of each, by its intensity.

uniform float in_opticsLineLightShares[OPTICS_LIGHT_SLOTS];
uniform vec3 in_opticsLineAmbient; // what every line has without lights

// ambientLight: what arrives of ambient light. opacity: of the sample.
vec3 opticsShadowedLines(vec3 color, vec3 ambientLight, float opacity)
{
  float own = opticsShadowOwn(opacity);
  float arriving = 0.0;
  for (int i = 0; i < OPTICS_NUMBER_OF_LIGHTS; ++i)
  {
    arriving += in_opticsLineLightShares[i] * opticsShadow(i, own);
  }
  vec3 ambient = min(color, in_opticsLineAmbient);
  return ambient * ambientLight + (color - ambient) * arriving;
}
