// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. VTK shortens its rays by the clipping planes; a sweep, and a gathering ray, ask each point.
bool opticsIsClipped(vec3 world)
{
  bool isClipped = false;
  for (int i = 1; i < int(in_clippingPlanes[0]); i += 6)
  {
    vec3 origin = vec3(in_clippingPlanes[i], in_clippingPlanes[i + 1], in_clippingPlanes[i + 2]);
    vec3 normal = vec3(in_clippingPlanes[i + 3], in_clippingPlanes[i + 4], in_clippingPlanes[i + 5]);
    isClipped = isClipped || dot(normal, world - origin) < 0.0;
  }
  return isClipped;
}
