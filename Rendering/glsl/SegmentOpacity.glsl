// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after SegmentPost or SegmentPreIntegrated, and SegmentIn*. The one integral of a
// part of any ray: scalars at its front and back, and its length in steps of the ray; mean colour and opacity.

vec4 opticsSegment(float front, float back, float steps)
{
  vec4 mean = opticsSegmentMean(front, back);
  return vec4(mean.rgb, SegmentOpacity(mean.a, opticsExtent(front, back, steps)));
}
