// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What an anisotropic voxel shows of one line type, told from the sums of its harmonics in the view direction:
// of the visible area's optical depth, of the light times this depth, and of their parts of degree 0 and 2.

// Truncated sums below this share of the mean hold more truncation than light.
const float LeastLineShare = 0.02;

// As opaque as makes a difference: half floats hold it, and the depth of what an opacity function makes opaque.
const float LargestLineDepth = 12.0;

// Optical depth over the mean chord of a voxel. depth: its sum, kept within DepthBounds(); degree0, degree2: parts
// of the depth. radiusScale >= 0, opacityScale in [0, 1]. 0 where there is no line.
float DepthOfLines(float depth, float degree0, float degree2, float radiusScale, float opacityScale)
{
  vec2 bounds = DepthBounds(degree0, degree2);
  float whole = clamp(depth, bounds.x, bounds.y) * radiusScale;
  float scaled = opacityScale < 1.0 ? OpticalDepth(opacityScale * OneMinusExp(whole)) : whole;
  return degree0 > 0.0 ? scaled : 0.0;
}

// Mean radiance of the lines: the ratio of light to depth; where the depth is too small for it, that of their
// means over all directions, light0 and degree0. degree0 > 0. Kept within what the material can be.
vec3 ColorOfLines(vec3 light, float depth, vec3 light0, float degree0, vec3 leastColor, vec3 largestColor)
{
  bool isSeen = depth > LeastLineShare * degree0;
  vec3 color = isSeen ? light / depth : light0 / degree0;
  return clamp(color, leastColor, largestColor);
}
