// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place ComputeRayDirection::Dec. In data space the opacity of a froxel is that of the scalar's change across it, which
// a slanting way does not make larger.
float opticsRelativeLength(float slices)
{
  return 1.0;
}
#endif
