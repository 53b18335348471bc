// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OPTICS_SWEEP // which has one sample, and no ray to skip on
    // Place Base::Impl, before VTK's text. To the next sample that may see something, by the additions that VTK makes
    // from sample to sample; where VTK would end the ray on the way, the sample after the leap ends it as well.
    // A rasteriser in software goes through the body of every loop at least once: one look-up in it, four steps at once.
    float opticsSkipped = 0.0;
    for (;;)
    {
      float opticsSteps = opticsEmptySteps(g_dataPos, opticsIsForward, opticsStepsPerCell);
      if (opticsSteps <= 0.0 || g_currentT + opticsSkipped - 1.0 >= g_terminatePointMax)
      {
        break;
      }
      opticsSkipped += opticsSteps;
      for (; opticsSteps > 0.0; opticsSteps -= 4.0)
      {
        vec4 opticsTaken = clamp(vec4(opticsSteps) - vec4(0.0, 1.0, 2.0, 3.0), 0.0, 1.0);
        g_dataPos += opticsTaken.x * g_dirStep;
        g_dataPos += opticsTaken.y * g_dirStep;
        g_dataPos += opticsTaken.z * g_dirStep;
        g_dataPos += opticsTaken.w * g_dirStep;
      }
    }
    g_currentT += opticsSkipped;
    if (opticsSkipped > 0.0 && opticsIsRayOver())
    {
      break;
    }
#endif
