// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where scalars are on the two parallel axes of a line histogram, in pixels of the scene.

#ifndef LightingEditorLayout_h
#define LightingEditorLayout_h

#include "vtkRect.h"
#include "vtkVector.h"

#include <algorithm>

namespace volumeoptics
{
// The axes: of S1, below or at the right, and of S2, above or at the left.
enum LightingAxis
{
  AxisOfS1 = 0,
  AxisOfS2 = 1
};

struct LightingEditorLayout
{
  vtkRectf Plot; // between the axes
  bool VerticalAxes = false;
  double Range[2] = { 0.0, 1.0 }; // of scalars, of a width above 0
  float AxisThickness = 14.0F;    // of the boxes' strips outside of the plot

  float Start() const { return this->VerticalAxes ? this->Plot.GetY() : this->Plot.GetX(); }
  float Length() const { return this->VerticalAxes ? this->Plot.GetHeight() : this->Plot.GetWidth(); }
  float Gap() const { return this->VerticalAxes ? this->Plot.GetWidth() : this->Plot.GetHeight(); }

  // Along the axes.
  float PixelOf(double scalar) const
  {
    const double position = (scalar - this->Range[0]) / (this->Range[1] - this->Range[0]);
    return this->Start() + static_cast<float>(position * this->Length());
  }
  float AlongAt(const vtkVector2f& pixel) const { return this->VerticalAxes ? pixel.GetY() : pixel.GetX(); }
  double ScalarAt(const vtkVector2f& pixel) const
  {
    const double position = (this->AlongAt(pixel) - this->Start()) / std::max(this->Length(), 1.0F);
    return this->Range[0] + position * (this->Range[1] - this->Range[0]);
  }

  // From 0 at the axis of S1 to 1 at that of S2.
  double AcrossAt(const vtkVector2f& pixel) const
  {
    const double across = this->VerticalAxes ? this->Plot.GetX() + this->Plot.GetWidth() - pixel.GetX()
                                             : pixel.GetY() - this->Plot.GetY();
    return across / std::max(this->Gap(), 1.0F);
  }

  // across: may be outside of [0, 1].
  vtkVector2f Point(double across, double scalar) const
  {
    const float along = this->PixelOf(scalar);
    const float away = static_cast<float>(across) * this->Gap();
    return this->VerticalAxes ? vtkVector2f(this->Plot.GetX() + this->Plot.GetWidth() - away, along)
                              : vtkVector2f(along, this->Plot.GetY() + away);
  }
};
}

#endif
