// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place ComputeRayDirection::Dec. VTK classifies a sample: its opacity is that of a step of the ray.
float opticsRelativeLength(float slices)
{
  return slices * in_sweepStepsOfSlice;
}
#endif
