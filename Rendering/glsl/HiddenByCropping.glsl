// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec. VTK's cropping regions, whose planes are known.

bool opticsIsHidden(vec3 texPosition)
{
  return in_croppingFlags[computeRegion(croppingPlanesTexture, texPosition)] == 0;
}

// How much of the way from a visible to a hidden sample is visible: up to the first plane; a half where something else
// hides the sample.
float opticsVisiblePart(vec3 visible, vec3 hidden)
{
  float part = 2.0;
  for (int plane = 0; plane < 6; ++plane)
  {
    float from = visible[plane / 2];
    float to = hidden[plane / 2];
    float at = croppingPlanesTexture[plane];
    part = (from < at) != (to < at) ? min(part, (at - from) / (to - from)) : part;
  }
  return part > 1.0 ? 0.5 : part;
}
