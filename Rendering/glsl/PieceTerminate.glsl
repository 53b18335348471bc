// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Terminate::Init, behind VTK's text, which counts the steps to opaque geometry as if it lay behind the first
  // sample. VTK draws the sample behind the geometry, too.
  g_terminatePointMax = dot(g_terminatePos - g_dataPos, g_dirStep) / dot(g_dirStep, g_dirStep);
  g_exit = g_exit || g_terminatePointMax <= -1.0;
  g_terminatePointMax = min(g_terminatePointMax, g_opticsPieceEnd);
