// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Shading::Init. The ray begins where it enters the volume; the first sample is VTK's.
  g_terminatePos = opticsRayEnd;
  float opticsStepSquared = dot(g_dirStep, g_dirStep);
  g_opticsPlace = dot(g_dataPos - g_rayOrigin, g_dirStep) / opticsStepSquared;
  g_opticsEnd = opticsPlaceOfEnd(g_terminatePos);
  float opticsEntry = -dot(g_rayJitter, g_dirStep) / opticsStepSquared;
  if (zStart >= 0.0) // depth peeling: a part of the ray that may begin between two samples
  {
    vec4 opticsStart = ip_inverseTextureDataAdjusted * in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix *
      in_inverseProjectionMatrix * WindowToNDC(gl_FragCoord.x, gl_FragCoord.y, zStart);
    float opticsStartPlace = dot(opticsStart.xyz / opticsStart.w - g_rayOrigin, g_dirStep) / opticsStepSquared;
    opticsEntry = clamp(opticsStartPlace, opticsEntry, max(opticsEntry, g_opticsPlace));
  }
  g_opticsPlace = min(g_opticsPlace, g_opticsEnd);
  g_dataPos = g_rayOrigin + g_dirStep * g_opticsPlace;
  vec3 opticsEntryPosition = g_rayOrigin + g_dirStep * opticsEntry;
  g_opticsWasHidden = opticsIsHidden(opticsEntryPosition);
  opticsBeginAtPosition(opticsEntryPosition, opticsEntry);
