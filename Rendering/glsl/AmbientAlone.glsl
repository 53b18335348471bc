// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, in place of VTK's text; last. Radiance of one sample without Shade: ambient light and
// no other. A 2D function that VTK resizes overshoots.

vec4 computeLighting(vec4 color, int component, float label)
{
  float opacity = color.a * opticsGradientOpacity(component, label);
  return clamp(vec4(color.rgb * opticsAmbientLight(opacity), opacity), 0.0, 1.0);
}
