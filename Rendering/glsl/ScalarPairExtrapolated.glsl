// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. The scalars ahead and behind on the gradient, S1 and S2, as if the scalar
// were linear: no fetch beside the gradient's.

uniform float in_opticsPairStep; // in steps h

vec2 opticsScalarPair(vec3 texPosition, vec3 gradient)
{
  float scalar = dot(g_opticsScalar, in_opticsOpacityChannel);
  float change = length(gradient) * in_opticsPairStep;
  return vec2(scalar + change, scalar - change);
}
