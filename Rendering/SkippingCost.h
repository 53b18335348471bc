// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a frame that skips empty macrocells is estimated to cost, whatever the camera.

#ifndef SkippingCost_h
#define SkippingCost_h

#include "vtkVolumeOpticsModule.h" // for export macro

class VisibleScalars;
class vtkMacrocellGrid;

/** Times in those of a sample without skipping. */
struct SkippingTimes
{
  double Seen;       // of a sample that may see something, in a grid of few cells
  double SeenInMany; // more of it with 2^18 cells, in proportion: they leave the nearest cache
  double LookUp;     // of an empty cell
  double Step;       // of each sample that is leapt over
};

/**
 * Time of rays through a classified grid over that without skipping. The rays go through up to every 16th row of cells
 * on each axis, both ways, with two samples for each voxel, and end where the cells in front are opaque, their scalars
 * and their gradients, up to the largest one, taken as spread evenly. voxelsPerUnit: in
 * the distance that the table's opacities are of; 0 where rays should be taken to go all through.
 */
VTKVOLUMEOPTICS_EXPORT double EstimateSkipping(
  vtkMacrocellGrid* grid, const VisibleScalars& visible, double voxelsPerUnit, const SkippingTimes& times);

#endif
