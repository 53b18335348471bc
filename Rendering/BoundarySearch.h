// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Finds materials and the boundaries between them in a histogram of pairs along the gradient.

#ifndef BoundarySearch_h
#define BoundarySearch_h

#include "LightingBoundary.h"

class vtkImageData;

namespace volumeoptics
{
// The scalars that homogeneous regions have: the modes of the diagonal, rising.
std::vector<double> FindMaterials(vtkImageData* histogram);

// At most `count` boundaries between them, the strongest first, without coefficients.
std::vector<LightingBoundary> FindBoundaries(vtkImageData* histogram, int count);
}

#endif
