// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init. VTK ends the ray behind the sample of this number. Where the ray leaves the whole VTK knows it; a ray
  // through an edge of the whole, that leaves it before its first sample, has it all the same.
  bool opticsIsLastPiece = opticsInPiece.y >= opticsInWhole.y - 1.0e-4;
  bool opticsHasSample = g_opticsPieceEnd >= 0.0 || (opticsIsLastPiece && opticsInPiece.x <= opticsWholeEntry + 1.0e-4);
  g_exit = g_exit || !opticsHasSample;
  g_opticsPieceEnd = opticsIsLastPiece ? 1.0e20 : g_opticsPieceEnd;
