// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Optics::Light. A light on the other side than the viewer shines through, and is not reflected.
    float opticsBehind = light.attenuation * ShareBehind(opticsThroughNormal, light.toLight, g_opticsToViewer);
    light.attenuation -= opticsBehind;
