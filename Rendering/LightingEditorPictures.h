// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The histograms behind the editor of lighting transfer functions, drawn again only where they change.

#ifndef LightingEditorPictures_h
#define LightingEditorPictures_h

#include "LightingEditorLayout.h"

#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <array>

namespace volumeoptics
{
class LightingEditorPictures
{
public:
  vtkSmartPointer<vtkImageData> Histogram; // of pairs
  vtkSmartPointer<vtkImageData> GradientHistogram;
  vtkSmartPointer<vtkPiecewiseFunction> Opacity;
  vtkTimeStamp SettingsTime; // of what else the pictures depend on

  // panel: of the 2D histograms.
  void Update(const LightingEditorLayout& layout, const vtkRectf& panel, bool logScale, double tolerance);

  vtkImageData* GetLines() const { return this->Lines; }
  vtkImageData* GetGradients() const { return this->Gradients; }
  vtkImageData* GetPairs() const { return this->Pairs; }

private:
  bool IsUpToDate(const std::array<int, 4>& sizes) const;

  vtkSmartPointer<vtkImageData> Lines;
  vtkSmartPointer<vtkImageData> Gradients;
  vtkSmartPointer<vtkImageData> Pairs;
  vtkTimeStamp PictureTime;
  std::array<int, 4> Sizes = {}; // of the lines and of the 2D histograms
};
}

#endif
