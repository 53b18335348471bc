// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Shading::Init. Depth peeling casts a ray in parts, one of which may have ended outside.
  g_exit = false;
  opticsLeapOverNothing();
