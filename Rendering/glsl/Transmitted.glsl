// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Optics::Transmission, after TransmittedSide. The colour is the diffuse one, also of the highlight.
    vec2 opticsThrough = TransmittedLight(opticsThroughNormal, light.toLight, g_opticsToViewer, in_shininess[0]);
    transmitted += coefficients.diffuse * in_opticsLightDiffuse[i] *
      (opticsBehind * g_opticsTransmittedShare * (opticsThrough.x + in_opticsTransmittedSpecular * opticsThrough.y));
