// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Shading::Impl, in place of VTK's text. A term may change opticsColor at Optics::Lines.
    g_srcColor = vec4(0.0);
    if (!g_skip)
      {
      vec4 opticsLines = opticsLinesAt(opticsTexToLines(vec4(g_dataPos, 1.0)));
      g_srcColor.a = OneMinusExp(opticsLines.a * in_sampleDistance);
      vec3 opticsAmbient = opticsLineLight(g_srcColor.a);
      vec3 opticsColor = opticsLines.rgb * opticsAmbient;
      //Optics::Lines
      g_srcColor.rgb = opticsColor * g_srcColor.a;
      g_fragColor += (1.0 - g_fragColor.a) * g_srcColor;
      }
