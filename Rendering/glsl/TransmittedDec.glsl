// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. Light that shines through a surface from behind, [Kraus2005] eq. 19.

uniform float in_opticsTransmittedSpecular; // 0 or 1

float g_opticsTransmittedShare; // of the light behind what is lit, set before computeLighting()
