// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Optics::Surface. The sides are those of the scalar's isosurface.
  vec3 opticsThroughNormal = opticsNormalInEye(g_opticsScalarGradient);
