// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade visibility: what occlusion costs and how far it is from the cone integral by rays.

#ifndef TradeVisibility_h
#define TradeVisibility_h

#include "VisibilityBench.h"

struct VisibilityTradeOptions : VisibilityBench::Options
{
  std::string Folder = "trade";
  std::string Part = "all"; // algorithms, frames
};

// Writes visibility-algorithms.csv and .svg (the algorithms in double), visibility.csv and .svg (the mapper's
// frames); prints the figures.
void TradeVisibility(const VisibilityTradeOptions& options);

#endif
