// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A lighting transfer function's value at a pair of scalars, and its table.

#ifndef LightingTable_h
#define LightingTable_h

#include "LightingBoundary.h"

#include "vtkImageData.h"

namespace volumeoptics
{
// What a lighting transfer function consists of.
struct LightingFunction
{
  std::vector<LightingBoundary> Boundaries;
  vtkSmartPointer<vtkImageData> Image;
};

// Of its curves and its image, 0 without them.
vtkMTimeType LatestChange(const LightingFunction& function);

// The coefficients at a point of a table's image: 3, 2 (no specular) or 1 component (for all three).
LightingCoefficients TableCoefficients(vtkDataArray* values, vtkIdType point);

// The same between the points; 0 of an image without scalars.
LightingCoefficients ImageCoefficients(vtkImageData* image, double s1, double s2);

// The sum of boundaries and image, each coefficient at most 1.
LightingCoefficients Coefficients(const LightingFunction& function, double s1, double s2);

// size x size RGBA, as vtkLightingTransferFunction::GetTable().
std::vector<float> LightingTable(
  const LightingFunction& function, const double range[2], int size, vtkPiecewiseFunction* density);

// The same as an image whose points lie at (S1, S2).
void FillTableImage(const std::vector<float>& rgba, const double range[2], int size, vtkImageData* table);
}

#endif
