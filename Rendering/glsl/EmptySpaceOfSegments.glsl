// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OPTICS_SWEEP // which has one sample, and no ray to skip on
    // Place Base::Impl, before VTK's text. To the last sample before a segment that may see something, by the very steps
    // that the ray takes otherwise. The segment that ends there is as long as all that is skipped, and sees nothing.
    float opticsSteps = opticsEmptySteps(g_dataPos, opticsIsForward, opticsStepsPerCell);
    bool opticsIsEmpty = opticsIsShort && opticsSteps > 0.0;
    bool opticsSkips = opticsIsEmpty && opticsIsFrontEmpty;
    bool opticsIsPast = false;
    float opticsLastPlace = g_opticsPlace;
    opticsSteps = opticsSkips ? opticsSteps : 0.0;
    while (opticsSteps > 0.0)
    {
      opticsLastPlace = g_opticsPlace;
      for (; opticsSteps > 1.0; opticsSteps -= 1.0)
      {
        opticsLastPlace += 1.0;
      }
      opticsIsPast = opticsLastPlace >= g_opticsEnd;
      g_opticsPlace = min(opticsLastPlace + 1.0, g_opticsEnd);
      opticsSteps = opticsIsPast
        ? 0.0
        : opticsEmptySteps(g_rayOrigin + g_dirStep * g_opticsPlace, opticsIsForward, opticsStepsPerCell);
    }
    if (opticsIsPast)
    {
      break;
    }
    if (opticsSkips)
    {
      g_opticsPlace = opticsLastPlace;
      g_dataPos = g_rayOrigin + g_dirStep * g_opticsPlace;
    }
    opticsIsFrontEmpty = opticsIsEmpty;
#endif
