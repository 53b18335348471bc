// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after Silhouette*. A part of the segment that ends at g_dataPos, without surfaces,
// lit there. scalars: of the segment's end.

void opticsSmoothToEye(float from, float to, float steps, vec4 scalars)
{
  vec4 mean = opticsSegmentMean(from, opticsClassified(to, scalars));
  float extent = opticsExtent(from, to, steps);
  float opacity = opticsEyeOpacity(mean.a, extent, steps);
  if (opacity > 0.0)
  {
    opticsTransmit(from, to, mean.a * extent);
    opticsComposite(vec4(opticsColor(mean.rgb, scalars), opacity), scalars);
  }
}
