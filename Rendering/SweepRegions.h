// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The froxels of each slice that a sweep has to draw. All light reaches the others, or nobody looks at them.

#ifndef SweepRegions_h
#define SweepRegions_h

#include "vtkVolumeOpticsModule.h" // for export macro

#include <vector>

class SweepGrid;

/** Froxels [Begin, End) on x and y. */
struct SweepRectangle
{
  int Begin[2] = { 0, 0 };
  int End[2] = { 0, 0 };

  bool IsEmpty() const { return this->Begin[0] >= this->End[0] || this->Begin[1] >= this->End[1]; }
  bool operator==(const SweepRectangle& other) const
  {
    return this->Begin[0] == other.Begin[0] && this->Begin[1] == other.Begin[1] &&
      this->End[0] == other.End[0] && this->End[1] == other.End[1];
  }
};

/** Of the rays that a slice follows to the one before it. */
struct SweepCone
{
  double Angle;          // of the outmost ray with the axis, in radians
  bool IsAboutEye;       // the axis is the line to the viewer, not the slices' normal
  double ViewerDistance; // above 0: rays end on a disk at the viewer that appears under the angle from there
};

/** What is in a sweep. */
struct SweepContents
{
  double Corners[24];   // of a box in world coordinates: what hides is in it, and who looks
  bool IsHiddenOutside; // there is something else that hides
  double LookAlong;     // how far from a point in the box the sweep is looked at, along the slices' normal
  double LookAside;     // and across, in places
  SweepCone Cone;
};

/**
 * Of each slice: hidden can be what lies in the box, or behind it as seen by the cone; and of that, looked at is what lies
 * in the box, or in front of it.
 */
VTKVOLUMEOPTICS_EXPORT std::vector<SweepRectangle> FindSweepRegions(
  const SweepGrid& grid, const SweepContents& contents);

/** All froxels of all slices. */
std::vector<SweepRectangle> WholeSweep(const SweepGrid& grid);

#endif
