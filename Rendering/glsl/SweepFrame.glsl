// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
  // Place Shading::Init, after SweepRayEnd: what FrameInit is for a ray.
  g_opticsTexToFrame = in_opticsDataToFrame * inverse(ip_inverseTextureDataAdjusted);
#endif
