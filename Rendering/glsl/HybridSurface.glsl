// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Optics::Surface. Light is one-sided then.
  float hybridSide = HybridSide(g_opticsDensityDifference, in_opticsDensityFade);
  surface.normal = opticsHybridNormal(surface.normal, hybridSide);
  coefficients.specular *= abs(hybridSide);
