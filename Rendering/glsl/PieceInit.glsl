// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init, behind VTK's text. The samples are those of a ray through the whole volume, which begins where it
  // enters the whole, or where the view begins; the first one is the first in the piece. 1e-4: a sample
  // on a face between pieces is in the one behind it, whatever the rounding.
  vec2 opticsInWhole = opticsStepsThrough(ip_textureCoords, in_opticsWholeMin, in_opticsWholeMax);
  vec2 opticsInPiece = opticsStepsThrough(ip_textureCoords, in_texMin[0], in_texMax[0]);
  mat4 opticsPieceToEye = in_modelViewMatrix * in_volumeMatrix[0] * inverse(ip_inverseTextureDataAdjusted);
  float opticsNearestSteps = (-in_opticsNearest - (opticsPieceToEye * vec4(ip_textureCoords, 1.0)).z) /
    (opticsPieceToEye * vec4(g_dirStep, 0.0)).z;
  float opticsWholeEntry = max(opticsInWhole.x, opticsNearestSteps);
  float opticsPieceEntry = max(opticsInPiece.x, 0.0);
  float opticsFirst = opticsWholeEntry + dot(g_rayJitter, g_dirStep) / dot(g_dirStep, g_dirStep);
  opticsFirst += max(ceil(opticsPieceEntry - opticsFirst - 1.0e-4), 0.0);
  g_rayJitter = g_dirStep * (opticsFirst - opticsPieceEntry);
  g_rayOrigin = ip_textureCoords + g_dirStep * opticsFirst;
  g_opticsPieceEnd = ceil(opticsInPiece.y - opticsFirst - 1.0e-4) - 1.0;
  g_exit = opticsInPiece.y < opticsPieceEntry;
