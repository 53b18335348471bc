// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Terminate::Impl, in place of VTK's text: the same, but the last step ends where the ray does.
    if (g_fragColor.a > g_opacityThreshold || g_opticsPlace >= g_opticsEnd)
      {
      break;
      }
    ++g_currentT;
    g_opticsPlace = min(g_opticsPlace + 1.0, g_opticsEnd);
    g_dataPos = g_rayOrigin + g_dirStep * g_opticsPlace;
