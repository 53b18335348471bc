// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OpacityAt*. The gradient of the classified extinction along the
// stored normal: no fetch beside the normal's own, two look-ups in the opacity table.

uniform float in_opticsUnitStep; // ScalarOpacityUnitDistance / h

struct OpticsGradient
{
  vec3 normal;       // data space, unit, -grad(extinction) or 0
  vec3 frameNormal;  // data space, unit, -grad(s) or 0: what the frame is stored with
  float coefficient; // SpecularCoefficient
};

OpticsGradient opticsExtinctionGradient(float label)
{
  OpticsNormal stored = opticsStoredNormal(g_dataPos);
  float scalar = dot(g_opticsScalar, in_opticsOpacityChannel);
  float ahead = BoundedOpticalDepth(opticsOpacityAt(scalar + stored.change, g_dataPos, stored.change, label));
  float behind = BoundedOpticalDepth(opticsOpacityAt(scalar - stored.change, g_dataPos, stored.change, label));
  OpticsGradient gradient;
  gradient.normal = ahead >= behind ? stored.normal : -stored.normal;
  gradient.frameNormal = stored.normal;
  gradient.coefficient = SpecularCoefficient(ahead, behind, in_opticsUnitStep);
  return gradient;
}
