// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Draws the editor of lighting transfer functions.

#ifndef LightingEditorPainter_h
#define LightingEditorPainter_h

#include "LightingEditor.h"

#include "vtkRect.h"

#include <string>
#include <vector>

class vtkContext2D;
class vtkImageData;

namespace volumeoptics
{
// Red, green, blue in [0, 255] of a boundary's boxes: eight colours that also differ for the colour-blind,
// over and over.
std::array<unsigned char, 3> BoundaryColor(int boundary);

class LightingEditorPainter
{
public:
  LightingEditorPainter(vtkContext2D* painter, const LightingEditor& editor)
    : Painter(painter)
    , Editor(editor)
  {
  }

  // The area between the axes, over the picture of the line histogram.
  void DrawBackground(const vtkRectf& rectangle) const;
  void DrawPicture(const vtkRectf& rectangle, vtkImageData* picture) const;
  void DrawAxes() const;
  void DrawBoundaries() const;
  void DrawTrace() const;
  // Text centred on a point.
  void DrawText(const std::string& text, float x, float y, bool isLeft = false) const;
  // The first of the texts that is not wider; none if all are.
  void DrawLongest(
    const std::vector<std::string>& texts, float x, float y, float width, bool isLeft = false) const;
  // What the selected boundary has, or what can be done without one.
  void DrawStatus(float x, float y, float width) const;

private:
  void SetFont() const;
  std::vector<std::string> Help() const;
  std::vector<std::string> Coefficients(int boundary) const;
  void DrawBand(int boundary) const;
  void DrawBox(int boundary, int axis) const;

  vtkContext2D* Painter;
  const LightingEditor& Editor;
};
}

#endif
