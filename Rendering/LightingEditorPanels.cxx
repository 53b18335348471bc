// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingEditorPanels.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
const float TickSpace = 18.0F;  // for numbers under a horizontal axis
const float TickWidth = 36.0F;  // beside a vertical one
const float HalfNumber = 14.0F; // of a number at the end of an axis
const float LeastPlot = 8.0F;
const float HistogramShare = 0.36F; // of the width
}

LightingEditorPanels::LightingEditorPanels(const vtkRectf& all, bool withHistograms)
  : All(all)
{
  const float side = withHistograms ? HistogramShare * all.GetWidth() : 0.0F;
  const float half = 0.5F * all.GetHeight();
  const float left = all.GetX() + all.GetWidth() - side;
  const auto histogram = [&](float bottom) {
    return vtkRectf(left, bottom + PanelMargin, std::max(side - PanelMargin, 1.0F),
      std::max(half - TitleHeight - 2.0F * PanelMargin, 1.0F));
  };
  this->Lines = vtkRectf(all.GetX(), all.GetY(), all.GetWidth() - side, all.GetHeight());
  this->Gradients = histogram(all.GetY() + half);
  this->Pairs = histogram(all.GetY());
}

vtkRectf LightingEditorPanels::Plot(bool vertical, float thickness) const
{
  const float acrossStart = (vertical ? TickWidth : TickSpace) + thickness;
  const float alongStart = PanelMargin + (vertical ? 0.0F : HalfNumber);
  const float x = vertical ? acrossStart : alongStart;
  // the status below, the titles above
  const float y = TitleHeight + (vertical ? alongStart : acrossStart);
  const float top = TitleHeight + (vertical ? PanelMargin : acrossStart);
  const vtkRectf& panel = this->Lines;
  return vtkRectf(panel.GetX() + x, panel.GetY() + y, std::max(panel.GetWidth() - 2.0F * x, LeastPlot),
    std::max(panel.GetHeight() - y - top, LeastPlot));
}
}
