// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init, after VTK's text.
  g_opticsTexToLines = in_opticsDataToLines * inverse(ip_inverseTextureDataAdjusted);
