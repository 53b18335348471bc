// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after SegmentSmooth. Nothing between smooth parts of the ray.

void opticsBeginAt(float scalar)
{
}

void opticsSegmentToEye(float front, float back, float steps, vec4 scalars)
{
  opticsSmoothToEye(front, back, steps, scalars);
}
