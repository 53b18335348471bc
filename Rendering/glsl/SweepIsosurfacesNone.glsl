// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place ComputeRayDirection::Dec.
float opticsIsosurfacesTransmittance(float front, float back)
{
  return 1.0;
}
#endif
