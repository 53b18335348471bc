// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The gestures that edit a lighting transfer function on two parallel axes, without painting and
// without events.

#ifndef LightingEditor_h
#define LightingEditor_h

#include "LightingEditHistory.h"
#include "LightingBoundary.h"
#include "LightingEditorLayout.h"

#include <array>
#include <string>

namespace volumeoptics
{
class LightingEditor
{
public:
  // What is under a pixel.
  enum PartType
  {
    Nothing,
    Plot,   // no boundary
    Band,   // between a boundary's boxes: moves both
    Box,    // moves
    LowEnd, // resizes
    HighEnd
  };
  struct Target
  {
    PartType Part = Nothing;
    int Boundary = -1;
    int Side = 0;
  };

  LightingEditorLayout Layout;

  void SetFunction(vtkLightingTransferFunction* function);
  vtkLightingTransferFunction* GetFunction() const { return this->Function; }

  // -1: none.
  int GetSelected() const;
  int GetSelectedSide() const { return this->Side; }
  int GetCoefficient() const { return this->Coefficient; }
  void Select(int boundary);

  // The side of a boundary that is shown on the axis of S1: the one of larger scalars, unless a drag
  // has just changed that.
  int SideOnS1(int boundary) const;

  Target Find(const vtkVector2f& pixel) const;

  // A drag with the left button. Release() ends it; the line of a new boundary is drawn by a drag from
  // axis to axis.
  void Press(const vtkVector2f& pixel);
  void Drag(const vtkVector2f& pixel);
  void Release(const vtkVector2f& pixel);
  void Cancel();
  bool IsDragging() const { return this->Pressed.Part != Nothing; }
  bool IsTracing() const { return this->Pressed.Part == Plot; }
  const std::array<vtkVector2f, 2>& GetTrace() const { return this->Trace; }

  // A boundary of a homogeneous region, around a scalar on both axes.
  void AddAround(double s1, double s2);
  int Guess(vtkImageData* histogram, int number);
  void RemoveSelected();
  void ChangeSoftness(double steps);

  // A key by its VTK symbol; false if it means nothing here.
  bool Key(const std::string& symbol, bool control, bool shift);

  bool Undo();
  bool Redo();

private:
  bool IsSelected() const { return this->GetSelected() >= 0; }
  bool IsMovable(int boundary, int side) const;
  bool KeyOfHistory(const std::string& symbol, bool redo);
  bool KeyOfAll(const std::string& symbol);
  bool KeyOfSelected(const std::string& symbol, bool shift);
  double StripWidth() const;
  PartType PartOfBox(const double range[2], float along) const;
  Target FindOnAxes(const vtkVector2f& pixel) const;
  Target FindBand(const vtkVector2f& pixel) const;
  void ChangeCoefficient(double change);
  void Move(double scalars);
  void Widen(double scalars);
  double RangeWidth() const;
  void AddTraced();
  void RememberRanges(int boundary);

  vtkSmartPointer<vtkLightingTransferFunction> Function;
  LightingEditHistory History;
  int Selected = -1;
  int Side = 0;
  int Coefficient = 1;

  Target Pressed;
  bool IsRecorded = false; // the drag has changed something
  int FrozenSideOnS1 = 0;
  std::array<vtkVector2f, 2> Trace = { vtkVector2f(0.0F, 0.0F), vtkVector2f(0.0F, 0.0F) };
  std::array<std::array<double, 2>, 2> StartRanges = {}; // of both sides
};
}

#endif
