// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after Silhouette*. A part of the ray without surfaces, lit at g_dataPos.

void opticsSmoothToEye(float front, float back, float steps, vec4 scalars)
{
  vec4 mean = opticsSegmentMean(front, back);
  float opacity = opticsEyeOpacity(mean.a, opticsExtent(front, back, steps), steps);
  if (opacity > 0.0)
  {
    opticsComposite(vec4(opticsColor(mean.rgb, scalars), opacity), scalars);
  }
}
