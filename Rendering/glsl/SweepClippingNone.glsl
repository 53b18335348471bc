// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec.
bool opticsIsClipped(vec3 world)
{
  return false;
}
