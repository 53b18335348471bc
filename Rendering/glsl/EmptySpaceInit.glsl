// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Shading::Init.
  vec3 opticsIsForward = step(vec3(0.0), g_dirStep);
  vec3 opticsStepsPerCell = 1.0 / max(abs(g_dirStep * in_opticsMacrocells), vec3(1.0e-6));
