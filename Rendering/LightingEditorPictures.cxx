// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingEditorPictures.h"

#include "HistogramPicture.h"

#include <algorithm>

namespace volumeoptics
{
bool LightingEditorPictures::IsUpToDate(const std::array<int, 4>& sizes) const
{
  vtkMTimeType newest = this->SettingsTime;
  for (vtkObject* object : { static_cast<vtkObject*>(this->Histogram),
         static_cast<vtkObject*>(this->GradientHistogram), static_cast<vtkObject*>(this->Opacity) })
  {
    newest = object ? std::max(newest, object->GetMTime()) : newest;
  }
  return this->Lines && sizes == this->Sizes && newest < this->PictureTime;
}

void LightingEditorPictures::Update(
  const LightingEditorLayout& layout, const vtkRectf& panel, bool logScale, double tolerance)
{
  const std::array<int, 4> sizes = { static_cast<int>(layout.Length()), static_cast<int>(layout.Gap()),
    static_cast<int>(panel.GetWidth()), static_cast<int>(panel.GetHeight()) };
  if (this->IsUpToDate(sizes))
  {
    return;
  }
  this->Sizes = sizes;
  this->PictureTime.Modified();
  const auto [length, gap, width, height] = sizes;
  this->Lines = LineHistogramPicture(this->Histogram, length, gap, { logScale, this->Opacity, tolerance });
  if (layout.VerticalAxes)
  {
    this->Lines = Transposed(this->Lines);
  }
  this->Gradients = HistogramPicture(this->GradientHistogram, width, height, logScale);
  this->Pairs = HistogramPicture(this->Histogram, width, height, logScale);
}
}
