// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OpacityTable. Scalar opacity times VTK's gradient opacity.

uniform float in_opticsChangeToVTK; // change over a step to VTK's magnitude: a quarter of the range is 1

float opticsOpacityAt(float scalar, vec3 texPosition, float change, float label)
{
  float magnitude = clamp(change * in_opticsChangeToVTK, 0.0, 1.0);
  return opticsTableOpacity(scalar) * computeGradientOpacity(vec4(0.0, 0.0, 0.0, magnitude));
}
