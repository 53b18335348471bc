// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place ComputeRayDirection::Dec.
bool opticsIsClipped(vec3 world)
{
  return false;
}
#endif
