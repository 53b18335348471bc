// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, in place of VTK's text; last. Radiance of one sample, not clamped. Terms add
// to it at its own places; what each may read and write:
//   Optics::Gradient      g_opticsScalarGradient, where a term needs it: first of all
//   Optics::Surface       surface, ambient (vec3, times the colour): before the lights
//   Optics::Light         light (its attenuation): before a light is used
//   Optics::Transmission  transmitted (vec3, times the colour): after a light was used

// The largest half float: what is drawn into a float target stays finite.
const float opticsLargestRadiance = 65504.0;

vec4 computeLighting(vec4 color, int component, float label)
{
  //Optics::Gradient
  OpticsSurface surface = opticsSurface(label);
  OpticsCoefficients coefficients = opticsCoefficients(component);
  vec3 ambient = coefficients.ambient;
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec3 transmitted = vec3(0.0);
  //Optics::Surface
  for (int i = 0; i < OPTICS_NUMBER_OF_LIGHTS; ++i)
  {
    OpticsLight light = opticsLight(i);
    //Optics::Light
    diffuse += in_opticsLightDiffuse[i] * (light.attenuation * opticsScattering(surface, light.toLight));
    specular += in_opticsLightSpecular[i] * (light.attenuation * opticsReflection(surface, light.toLight));
    //Optics::Transmission
  }
  vec3 radiance = color.rgb * (ambient + coefficients.diffuse * diffuse + transmitted) +
    coefficients.specular * (surface.coefficient * specular);
  // a 2D function that VTK resizes overshoots
  float opacity = clamp(color.a * opticsGradientOpacity(component, label), 0.0, 1.0);
  return vec4(clamp(radiance, 0.0, opticsLargestRadiance), opacity);
}
