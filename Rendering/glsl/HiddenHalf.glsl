// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. Masks and blanking are known at samples only.

bool opticsIsHidden(vec3 texPosition)
{
  return false;
}

// How much of the way from a visible to a hidden sample is visible: a half, so that the sum is right on average.
float opticsVisiblePart(vec3 visible, vec3 hidden)
{
  return 0.5;
}
