// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Cuts the range of a table into stretches on which the transfer functions are linear, or nearly so.

#ifndef TransferFunctionStretches_h
#define TransferFunctionStretches_h

#include "AttenuatedStretch.h"

#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace volumeoptics
{
struct TransferFunctions
{
  vtkColorTransferFunction* Color = nullptr;
  vtkPiecewiseFunction* Opacity = nullptr;
  double Range[2] = { 0.0, 1.0 }; // scalars of 0 and 1
  double Attenuation = 1.0;       // per normalised scalar, or length, at an optical depth of 1
};

// With what tells where a peak of opacity ends.
struct PlacedStretch : Stretch
{
  double begin = 0.0;
  bool transparentBelow = false; // opacity 0 at its lower end
  bool transparentAbove = false;
};

// Stretches of [0, 1] in ascending order, cut at every node and midpoint of the functions, within sharp
// curves, and at multiples of 1/parts. Linear pieces of the functions come out exactly; so do coincident
// nodes, for only points between the cuts are looked at.
std::vector<PlacedStretch> CutIntoStretches(const TransferFunctions& functions, int parts);
}

#endif
