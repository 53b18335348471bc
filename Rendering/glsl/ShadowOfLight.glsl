// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Optics::Light, first: the other terms share out what arrives.
    light.attenuation *= opticsShadow(i, opticsOwnShadow);
