// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a 2D transfer function shows.

#ifndef VisibleIn2D_h
#define VisibleIn2D_h

#include "OpticsScene.h"

#include <vector>

/** Of each column of the function, which is a scalar. */
struct Columns2D
{
  std::vector<float> Opacities;      // the largest, also of columns that VTK mixes in
  std::vector<float> LeastGradients; // of the rows that are seen; empty where they tell nothing
};

/** Whether the scene's function has opacities that VTK takes. */
bool IsUsable2D(const OpticsScene& scene);

Columns2D FindColumns2D(const OpticsScene& scene);

#endif
