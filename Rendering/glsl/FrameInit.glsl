// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init, after RayInit.
  g_opticsTexToFrame = in_opticsDataToFrame * opticsTexToData;
