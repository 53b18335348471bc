// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Optics::Surface, after Hybrid*.
  ambient *= opticsAmbientLight(color.a * opticsGradientOpacity(component, label));
