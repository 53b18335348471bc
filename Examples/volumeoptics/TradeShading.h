// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade shading: time of a frame against its error, the double-precision ray caster's
// picture of the same scene being the truth.

#ifndef TradeShading_h
#define TradeShading_h

#include <string>

struct ShadingTradeOptions
{
  std::string Folder = "trade";
  std::string Field = "tubes"; // see GalleryField()
  std::string Model = "ward";
  int Size = 160;
  bool Headless = false;
};

// Writes shading.csv and shading.svg.
void TradeShading(const ShadingTradeOptions& options);

#endif
