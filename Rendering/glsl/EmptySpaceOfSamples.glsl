// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OPTICS_SWEEP // which has one sample, and no ray to skip on
    // Place Base::Impl, before VTK's text. To the next sample that may see something, by the additions that VTK makes
    // from sample to sample; where VTK would end the ray on the way, the sample after the leap ends it as well.
    bool opticsIsPast = false;
    float opticsSteps = opticsEmptySteps(g_dataPos, opticsIsForward, opticsStepsPerCell);
    while (opticsSteps > 0.0)
    {
      g_currentT += opticsSteps;
      for (; opticsSteps > 0.0; opticsSteps -= 1.0)
      {
        g_dataPos += g_dirStep;
      }
      opticsIsPast = g_currentT - 1.0 >= g_terminatePointMax ||
        any(greaterThan(max(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMax[0]), vec3(0.0))) ||
        any(greaterThan(min(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMin[0]), vec3(0.0)));
      opticsSteps = opticsIsPast ? 0.0 : opticsEmptySteps(g_dataPos, opticsIsForward, opticsStepsPerCell);
    }
    if (opticsIsPast)
    {
      break;
    }
#endif
