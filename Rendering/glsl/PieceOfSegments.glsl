// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init. A segment belongs to the piece that its last sample is in, and may begin in ghost layers; where
  // there are none it is parted at the face.
  g_rayJitter = g_dirStep * (opticsFirst - max(max(opticsFirst - 1.0, opticsWholeEntry), 0.0));
  vec2 opticsInInput = opticsStepsThrough(ip_textureCoords, in_opticsInputMin, in_opticsInputMax);
  bool opticsIsParted = min(opticsInWhole.y, opticsInInput.y) <= opticsInPiece.y + 1.0e-4;
  g_opticsPieceEnd = opticsIsParted ? opticsInPiece.y - opticsFirst : g_opticsPieceEnd;
