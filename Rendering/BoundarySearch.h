// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Finds the boundaries between materials in a histogram of pairs along the gradient.

#ifndef BoundarySearch_h
#define BoundarySearch_h

#include "LightingBoundary.h"

class vtkImageData;

namespace volumeoptics
{
// At most `count` boundaries, the strongest first, without coefficients.
std::vector<LightingBoundary> FindBoundaries(vtkImageData* histogram, int count);
}

#endif
