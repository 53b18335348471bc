// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OpacityTable. VTK's 2D function, whose coordinates are globals.

uniform float in_opticsChangeToVTK; // change over a step to VTK's magnitude: a quarter of the range is 1

float opticsOpacityAt(float scalar, vec3 texPosition, float change, float label)
{
  vec3 position = g_dataPos;
  float magnitude = g_gradients_0[0].w;
  g_dataPos = texPosition;
  g_gradients_0[0].w = clamp(change * in_opticsChangeToVTK, 0.0, 1.0);
  float opacity = computeOpacity(vec4(scalar));
  g_dataPos = position;
  g_gradients_0[0].w = magnitude;
  return opacity;
}
