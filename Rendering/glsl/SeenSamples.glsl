// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OPTICS_SWEEP // which has one sample, and no ray to go on along
    // Place Base::Impl, before VTK's text and behind EmptySpace. To the next sample that is seen, by the additions that
    // VTK makes from sample to sample: rays of one group, which a processor takes together, then do the costly part of
    // a sample at once. Where VTK would end the ray on the way, the sample after it ends it as well.
    bool opticsIsOver = false;
    while (!opticsIsOver && opticsIsUnseen(g_dataPos))
    {
      g_currentT += 1.0;
      g_dataPos += g_dirStep;
      opticsIsOver = opticsIsRayOver();
    }
    if (opticsIsOver)
    {
      break;
    }
#endif
