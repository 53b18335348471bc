// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init, behind VTK's text. The samples are those of a ray through the whole volume, which begins where it
  // enters the whole, or at the eye if that is inside; the first one is the first in the piece. 1e-4: rounding, so that
  // none is lost.
  float opticsStepLength2 = dot(g_dirStep, g_dirStep);
  vec2 opticsInWhole = opticsStepsThrough(ip_textureCoords, in_opticsWholeMin, in_opticsWholeMax);
  vec2 opticsInPiece = opticsStepsThrough(ip_textureCoords, in_texMin[0], in_texMax[0]);
  vec4 opticsEye = ip_inverseTextureDataAdjusted * g_eyePosObj;
  float opticsToEye = dot(opticsEye.xyz / opticsEye.w - ip_textureCoords, g_dirStep) / opticsStepLength2;
  float opticsPieceEntry = max(opticsInPiece.x, 0.0);
  float opticsFirst = max(opticsInWhole.x, opticsToEye) + dot(g_rayJitter, g_dirStep) / opticsStepLength2;
  opticsFirst += max(ceil(opticsPieceEntry - opticsFirst - 1.0e-4), 0.0);
  g_rayJitter = g_dirStep * (opticsFirst - opticsPieceEntry);
  g_rayOrigin = ip_textureCoords + g_dirStep * opticsFirst;
  g_exit = opticsInPiece.y < opticsPieceEntry;
