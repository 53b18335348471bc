// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, for any silhouette: how the ray meets the isosurface at g_dataPos.

uniform float in_opticsGradientStepInverse; // 1/h, data space

vec3 opticsGradientInEye()
{
  return in_opticsNormalToEye * opticsScalarGradient(g_dataPos);
}

// Change of the scalar along the gradient over so many steps of the ray.
float opticsGradientStep(float steps)
{
  return length(opticsGradientInEye()) * g_opticsEyePerData * in_opticsGradientStepInverse * in_sampleDistance * steps;
}

// 1 where there is no gradient.
float opticsCosineToSurface()
{
  vec3 gradient = opticsGradientInEye();
  float steepness = length(gradient);
  return steepness > 0.0 ? abs(dot(gradient, g_opticsToViewer)) / steepness : 1.0;
}
