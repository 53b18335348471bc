// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. What a part of a segment, or a surface, lets through of the light behind it; the
// silhouette is the eye's alone.

uniform sampler1D in_opticsDepthsBehind; // to the end of the peak, towards larger and towards smaller scalars
uniform float in_opticsDepthsBehindSize;

vec2 opticsDepthsBehind(float scalar)
{
  return texture(in_opticsDepthsBehind, TableCoordinate(scalar, in_opticsDepthsBehindSize)).rg;
}

void opticsTransmit(float from, float to, float depth)
{
  vec2 front = opticsDepthsBehind(from);
  vec2 back = opticsDepthsBehind(to);
  float peak = max(front.x + front.y, back.x + back.y); // a segment that ends behind its peak began in it
  g_opticsTransmittedShare = TransmittedShare(min(depth, 1.0e30), to > from ? back.x : back.y, peak);
}

void opticsTransmitSurface(float opacity)
{
  g_opticsTransmittedShare = 1.0 - opacity;
}
