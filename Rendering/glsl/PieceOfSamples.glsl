// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init. A ray that leaves the piece before its first sample has none; one that leaves the whole has it
  // where it entered, as VTK draws it.
  bool opticsBeginsWhole = opticsInPiece.x <= opticsInWhole.x + 1.0e-4;
  g_exit = g_exit || (opticsFirst > opticsInPiece.y && (opticsFirst <= opticsInWhole.y || !opticsBeginsWhole));
