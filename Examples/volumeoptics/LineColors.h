// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colours of lines by their direction, as tractography shows them.

#ifndef LineColors_h
#define LineColors_h

#include <string>

class vtkPolyData;

// Adds an array of the points: red, green and blue are the shares along x, y and z. Returns its name.
std::string ColorByDirection(vtkPolyData* lines);

#endif
