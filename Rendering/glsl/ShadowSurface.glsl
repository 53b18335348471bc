// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Optics::Surface.
  float opticsOwnShadow = opticsShadowOwn(color.a * opticsGradientOpacity(component, label));
