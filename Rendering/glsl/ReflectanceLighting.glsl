// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, in place of VTK's text; last. Radiance of one sample, not clamped.

uniform float in_opticsScatteringAnisotropy;

// The largest half float: what is drawn into a float target stays finite.
const float opticsLargestRadiance = 65504.0;

vec4 computeLighting(vec4 color, int component, float label)
{
  OpticsSurface surface = opticsSurface(label);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  for (int i = 0; i < OPTICS_NUMBER_OF_LIGHTS; ++i)
  {
    OpticsLight light = opticsLight(i);
    float phase = HenyeyGreenstein(in_opticsScatteringAnisotropy, -dot(light.toLight, g_opticsToViewer));
    diffuse += in_opticsLightDiffuse[i] * (light.attenuation * phase);
    specular += in_opticsLightSpecular[i] * (light.attenuation * opticsReflection(surface, light.toLight));
  }
  vec3 radiance = color.rgb * (in_ambient[component] + in_diffuse[component] * diffuse) +
    in_specular[component] * (surface.coefficient * specular);
  return vec4(clamp(radiance, 0.0, opticsLargestRadiance), color.a * opticsGradientOpacity(component, label));
}
