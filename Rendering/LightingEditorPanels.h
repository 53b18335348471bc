// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where the parts of the editor of lighting transfer functions are, in pixels of the scene.

#ifndef LightingEditorPanels_h
#define LightingEditorPanels_h

#include "vtkRect.h"

namespace volumeoptics
{
// Around and between the panels, and of lines of text.
inline constexpr float PanelMargin = 6.0F;
inline constexpr float TitleHeight = 16.0F;

struct LightingEditorPanels
{
  vtkRectf All;
  vtkRectf Lines; // with axes, titles and status
  vtkRectf Gradients;
  vtkRectf Pairs;

  // The 2D histograms have no width where they are not shown.
  LightingEditorPanels() = default;
  LightingEditorPanels(const vtkRectf& all, bool withHistograms);

  // The area between the axes, whose strips for boxes have a thickness.
  vtkRectf Plot(bool vertical, float thickness) const;
};
}

#endif
