// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Shading::Init, after EmptySpaceInit. Cells that touch share voxels, so that all scalars between those of two
  // neighbours lie in their ranges: a segment sees nothing where it is no longer than a cell and both ends are empty.
  bool opticsIsShort = all(lessThanEqual(abs(g_dirStep * in_opticsMacrocells), vec3(1.0)));
  bool opticsIsFrontEmpty =
    opticsIsShort && opticsEmptySteps(opticsEntryPosition, opticsIsForward, opticsStepsPerCell) > 0.0;
