// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Shading::Init. The ray begins where it enters the volume; the first sample is VTK's.
  float opticsStepSquared = dot(g_dirStep, g_dirStep);
  g_opticsPlace = dot(g_dataPos - g_rayOrigin, g_dirStep) / opticsStepSquared;
  g_opticsEnd = opticsPlaceOfEnd(g_terminatePos);
  float opticsEntry = -dot(g_rayJitter, g_dirStep) / opticsStepSquared;
  opticsEntry = g_opticsPlace <= 1.001 ? opticsEntry : g_opticsPlace - 1.0;
  g_opticsPlace = min(g_opticsPlace, g_opticsEnd);
  g_dataPos = g_rayOrigin + g_dirStep * g_opticsPlace;
  vec3 opticsEntryPosition = g_rayOrigin + g_dirStep * opticsEntry;
  g_opticsWasHidden = opticsIsHidden(opticsEntryPosition);
  opticsBeginAtPosition(opticsEntryPosition, opticsEntry);
