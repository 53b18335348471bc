// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ExtinctionGradient*. Highlights where the classified extinction changes.

uniform float in_opticsSpecularFromExtinction; // 0 or 1
uniform float in_opticsGlossiness;

float opticsCoefficient(OpticsGradient gradient)
{
  return mix(1.0, gradient.coefficient, in_opticsSpecularFromExtinction);
}
