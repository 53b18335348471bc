// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ScalarGradient*. VTK's Phong model on the gradient of the scalar, for
// scenes that change something else about the light.

struct OpticsSurface
{
  vec3 normal; // eye space, unit, or 0
  float coefficient;
};

OpticsSurface opticsSurface(float label)
{
  return OpticsSurface(opticsNormalInEye(-g_opticsScalarGradient), 1.0);
}

// A cosine on the side that two-sided lighting, or its absence, lets count.
float opticsCosine(float cosine)
{
  return cosine < 0.0 ? -cosine * in_opticsTwoSided : cosine;
}

float opticsScattering(OpticsSurface surface, vec3 toLight)
{
  return opticsCosine(dot(surface.normal, toLight));
}

float opticsReflection(OpticsSurface surface, vec3 toLight)
{
  vec3 between = toLight + g_opticsToViewer;
  float cosine = opticsCosine(dot(surface.normal, between) * inversesqrt(max(dot(between, between), 1.0e-20)));
  return cosine > 0.0 ? pow(cosine, in_shininess[0]) : 0.0;
}
