// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

      // Place Optics::Lines.
      opticsColor = opticsShadowedLines(opticsLines.rgb, opticsAmbient, g_srcColor.a);
