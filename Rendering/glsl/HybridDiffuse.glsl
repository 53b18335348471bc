// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Optics::Surface, after HybridSurface, for a diffuse part that has a side.
  coefficients.diffuse *= abs(hybridSide);
