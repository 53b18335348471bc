// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How a light looks at a volume, for a visibility sweep.

#ifndef LightViews_h
#define LightViews_h

#include "SweepGrid.h"

#include <vector>

class vtkLight;

/** Views of one light at most. */
constexpr int LargestNumberOfViews = 6;

/**
 * Of a box, given by its corners in world coordinates (three numbers each): a parallel view of a directional
 * light; of a positional one a perspective view of the whole box, or of a narrower cone; where the box
 * surrounds the light, or is too near for one view, the six sides of a cube around the light. What the views
 * see of the box together is all that the light falls on.
 */
VTKVOLUMEOPTICS_EXPORT std::vector<SweepGrid::View> ViewsOfLight(vtkLight* light, const double corners[24]);

#endif
