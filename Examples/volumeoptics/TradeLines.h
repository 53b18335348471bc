// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade lines: time and memory of anisotropic voxels against the error of their picture, tubes
// rendered at ten times the resolution being the truth, as figure 4 of [Schussman2004].

#ifndef TradeLines_h
#define TradeLines_h

#include <string>

struct LinesTradeOptions
{
  std::string Folder = "trade";
  int Segments = 100000;
  int Size = 256;
  double Radius = 0.001; // an eighth of a voxel of 256 on [-1, 1]
  std::string Knob;      // the only one to measure; empty: all
  bool Headless = false;
};

// Writes lines.csv, lines.svg, lines-storage.csv, lines-storage.svg, and the pictures lines-tubes.png and lines-voxels.png.
void TradeLines(const LinesTradeOptions& options);

#endif
