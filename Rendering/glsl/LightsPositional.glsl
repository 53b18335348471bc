// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. Some light has a position: attenuation and cone as VTK's.

uniform vec3 in_opticsLightDiffuse[OPTICS_LIGHT_SLOTS];
uniform vec3 in_opticsLightSpecular[OPTICS_LIGHT_SLOTS];
uniform vec3 in_opticsLightDirection[OPTICS_LIGHT_SLOTS];   // eye space, unit, of travel
uniform vec3 in_opticsLightPosition[OPTICS_LIGHT_SLOTS];    // eye space
uniform vec3 in_opticsLightAttenuation[OPTICS_LIGHT_SLOTS]; // constant, linear, quadratic
uniform vec3 in_opticsLightCone[OPTICS_LIGHT_SLOTS];        // positional 0 or 1, cosine of the cone (-2: none), exponent

struct OpticsLight
{
  vec3 toLight;
  float attenuation;
};

OpticsLight opticsLight(int index)
{
  if (in_opticsLightCone[index].x == 0.0)
  {
    return OpticsLight(-in_opticsLightDirection[index], 1.0);
  }
  vec3 offset = in_opticsLightPosition[index] - (g_opticsTexToEye * vec4(g_dataPos, 1.0)).xyz;
  float distance = length(offset);
  OpticsLight light;
  light.toLight = distance > 0.0 ? offset / distance : g_opticsToViewer;
  vec3 falloff = in_opticsLightAttenuation[index];
  light.attenuation = 1.0 / max(falloff.x + distance * (falloff.y + distance * falloff.z), 1.0e-6);
  float cosine = -dot(light.toLight, in_opticsLightDirection[index]);
  if (in_opticsLightCone[index].y > -2.0)
  {
    light.attenuation *= cosine >= in_opticsLightCone[index].y ? pow(max(cosine, 1.0e-6), in_opticsLightCone[index].z) : 0.0;
  }
  return light;
}
