// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Optics::Light. A light on the other side than the viewer shines through, and is not reflected.
    bool opticsIsBehind = LightSide(opticsThroughNormal, light.toLight, g_opticsToViewer) < 0.0;
    float opticsBehind = opticsIsBehind ? light.attenuation : 0.0;
    light.attenuation -= opticsBehind;
