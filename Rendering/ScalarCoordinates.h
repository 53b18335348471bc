// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How VTK's tables are laid over the scalars, before it has loaded the volume, too.

#ifndef ScalarCoordinates_h
#define ScalarCoordinates_h

#include "OpticsScene.h"

#include <vector>

class vtkPiecewiseFunction;

/** The range of the scalars that opacity depends on, as VTK keeps it. */
void FindDataRange(const OpticsScene& scene, double range[2]);

/** The scalars that coordinates 0 and 1 stand for: VTK takes codes of 8 and 16 bits for one more than there are. */
void FindCoordinateRange(const OpticsScene& scene, double range[2]);

/** Entries of VTK's table on an axis where it needs so many: a power of two from 1024 on, if OpenGL has it. */
int FindTableSize(const OpticsScene& scene, int wanted);

/** VTK's table of a function over the values from first to last, for which it estimates the entries in another range. */
std::vector<float> MakeVTKTable(
  const OpticsScene& scene, vtkPiecewiseFunction* function, const double range[2], double first, double last);

#endif
