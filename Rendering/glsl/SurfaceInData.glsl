// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ExtinctionGradient*. In data space: a specular coefficient that depends on the
// scalar alone, |tau'| u^2 with the attenuation tau and the unit u of data, as a difference over one unit; and
// isosurfaces, which have the scalar's normal and a coefficient of 1.

uniform float in_opticsHalfUnit; // of the range of the scalars

OpticsGradient opticsSurfaceGradient(float label)
{
  OpticsGradient gradient = opticsExtinctionGradient(label);
  if (g_opticsIsSurface)
  {
    gradient.normal = gradient.frameNormal;
    gradient.coefficient = 1.0;
    return gradient;
  }
  float scalar = dot(g_opticsScalar, in_opticsOpacityChannel);
  float ahead = BoundedOpticalDepth(opticsTableOpacity(scalar + in_opticsHalfUnit));
  float behind = BoundedOpticalDepth(opticsTableOpacity(scalar - in_opticsHalfUnit));
  gradient.coefficient = SpecularCoefficient(ahead, behind, 2.0);
  return gradient;
}
