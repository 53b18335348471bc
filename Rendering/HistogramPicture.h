// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Histograms as pictures: RGB images, density as intensity.

#ifndef HistogramPicture_h
#define HistogramPicture_h

#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"

namespace volumeoptics
{
struct HistogramPictureSettings
{
  bool LogScale = true;
  vtkPiecewiseFunction* Opacity = nullptr; // marks the lines that link equal ones, where set
  double OpacityTolerance = 0.02;
};

// The line histogram [Lum2004, figure 2 (c)] of a histogram of pairs: each pair is a line from S1 in the
// bottom row to S2 in the top row, scalars rise to the right.
vtkSmartPointer<vtkImageData> LineHistogramPicture(
  vtkImageData* histogram, int width, int height, const HistogramPictureSettings& settings);

// The same with rows and columns exchanged: S1 in the right column, scalars rise upwards.
vtkSmartPointer<vtkImageData> Transposed(vtkImageData* picture);

// A 2D histogram; bins that share a pixel are summed. Smaller than asked for where there are fewer bins.
vtkSmartPointer<vtkImageData> HistogramPicture(vtkImageData* histogram, int width, int height, bool logScale);
}

#endif
