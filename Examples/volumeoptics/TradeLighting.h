// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade lighting: time of a frame with a lighting transfer function against its error, the
// double-precision ray caster's picture of the same scene, which has no table, being the truth.

#ifndef TradeLighting_h
#define TradeLighting_h

#include <string>

struct LightingTradeOptions
{
  std::string Folder = "trade";
  std::string Field = "tubes"; // see GalleryField()
  int Size = 160;
  bool Headless = false;
};

// Writes lighting.csv and lighting.svg.
void TradeLighting(const LightingTradeOptions& options);

#endif
