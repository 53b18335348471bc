// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place ComputeRayDirection::Dec. The opacity of a froxel is that of the distance of the slices.
float opticsRelativeLength(float slices)
{
  return slices;
}
#endif
