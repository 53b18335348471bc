// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The scene of [Kraus2005] figure 8 f: a buckyball of 32^3 points cut into 148,955 tetrahedra, five a
// cube, drawn in data space.

#ifndef BuckyballScene_h
#define BuckyballScene_h

#include "vtkAnalyticVolumeSource.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace buckyball
{
inline vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int points = 32)
{
  vtkNew<vtkAnalyticVolumeSource> source;
  source->SetFieldToBuckyball();
  source->SetRadius(0.7);
  source->SetDimensions(points, points, points);
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputConnection(source->GetOutputPort());
  cut->Update();
  return cut->GetOutput();
}

// Faint everywhere, so that no layer hides the next ones, from blue outside to yellow at the atoms.
inline void SetFunctions(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.1, 0.15, 0.3, 0.9);
  color->AddRGBPoint(0.5, 0.9, 0.25, 0.2);
  color->AddRGBPoint(0.9, 1.0, 0.9, 0.3);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.1, 0.004);
  opacity->AddPoint(1.0, 0.004);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
}
}

#endif
