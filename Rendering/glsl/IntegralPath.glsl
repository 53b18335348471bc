// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Clipping::Impl. Depth peeling leaves out parts of the ray without a sample, which have a segment here: for
  // its check the part is longer than from any place to a sample behind it.
  vec3 opticsRayEnd = g_terminatePos;
  g_terminatePos += zStart < 0.0 ? vec3(0.0) : 3.0 * g_dirStep;
