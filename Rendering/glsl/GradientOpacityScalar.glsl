// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. VTK's gradient opacity, which its computeLighting() applies.

float opticsGradientOpacity(int component, float label)
{
  vec4 gradient = computeGradient(g_dataPos, component, in_volume[0], 0);
  return gradient.w >= 0.0 && label == 0.0 ? computeGradientOpacity(gradient) : 1.0;
}
