// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ExtinctionGradient*.

struct OpticsSurface
{
  vec3 normal; // eye space, unit, or 0
  float coefficient;
};

OpticsSurface opticsSurface(float label)
{
  OpticsGradient gradient = opticsSurfaceGradient(label);
  return OpticsSurface(opticsNormalInEye(gradient.normal), opticsCoefficient(gradient));
}

float opticsReflection(OpticsSurface surface, vec3 toLight)
{
  vec3 normal = opticsFacing(surface.normal, toLight);
  return BlinnPhongReflection(normal, toLight, g_opticsToViewer, in_opticsGlossiness);
}
