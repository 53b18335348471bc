// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Opacity and optical depth. An opacity belongs to a length, VTK's ScalarOpacityUnitDistance D;
// its optical depth tau = -ln(1 - opacity) is the extinction over that length.

// An opaque material has no finite optical depth; derivatives of it end here.
const float LargestOpacityOfDepth = 0.999;

// Bound of the specular coefficient: a jump of the whole optical depth within one voxel gives 3.5.
const float LargestSpecularCoefficient = 16.0;

// 1 - exp(-x) without cancellation. x >= 0.
float OneMinusExp(float x)
{
  return x < 0.01 ? x * (1.0 - x / 2.0 * (1.0 - x / 3.0)) : 1.0 - exp(-x);
}

// -ln(1 - opacity) without cancellation. opacity in [0, 1).
float OpticalDepth(float opacity)
{
  float series = opacity * (1.0 + opacity * (1.0 / 2.0 + opacity * (1.0 / 3.0 + opacity / 4.0)));
  return opacity < 0.01 ? series : -log(max(1.0 - opacity, 1.0e-30));
}

// Optical depth with opaque materials bounded at LargestOpacityOfDepth (depth 6.9), for derivatives.
float BoundedOpticalDepth(float opacity)
{
  return OpticalDepth(clamp(opacity, 0.0, LargestOpacityOfDepth));
}

// Opacity over another length, 1 - (1 - opacity)^relativeLength; VTK's opacity correction.
// opacity in [0, 1] per unit distance D; relativeLength = length / D >= 0. 1 stays 1.
float OpacityForLength(float opacity, float relativeLength)
{
  return opacity >= 1.0 ? 1.0 : OneMinusExp(OpticalDepth(opacity) * relativeLength);
}

// Scale-free specular coefficient D |grad(tau)|, [Ament2015] eq. 6 at D = 1 and spacing 1.
// depthAhead, depthBehind: BoundedOpticalDepth one step h ahead of and behind the point;
// unitStep: D / h.
float SpecularCoefficient(float depthAhead, float depthBehind, float unitStep)
{
  return min(abs(depthAhead - depthBehind) / 2.0 * unitStep, LargestSpecularCoefficient);
}
