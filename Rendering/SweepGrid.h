// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The grid of a visibility sweep: slices across the direction in which an eye or a light looks at a volume.
// Its cells (froxels) are squares of the view: of the same angle in perspective, of the same size in parallel.
//
// View coordinates: x and y across the slices, z the distance along their normal, ahead of the viewer.
// Places on a slice are x/z and y/z in perspective, x and y in parallel.

#ifndef SweepGrid_h
#define SweepGrid_h

#include "vtkVolumeOpticsModule.h" // for export macro

class VTKVOLUMEOPTICS_EXPORT SweepGrid
{
public:
  /** What an eye or a light sees. */
  struct View
  {
    double WorldToView[16]; // row by row, as vtkMatrix4x4
    bool IsPerspective;
    double Range[2];  // of z; its least is above 0 in perspective
    double Window[4]; // least and largest place on x and y
  };

  /** How fine it is, within what a texture holds. */
  struct Resolution
  {
    int Size;             // froxels along the longer side
    double SliceDistance; // over the side of a froxel half-way
    int LargestSize;
  };

  /** No slices. */
  SweepGrid() = default;

  /**
   * Around what the view sees of a box, given by its corners in world coordinates (three numbers each).
   * Cones that leave the window find what is within a quarter of its width around it, and on as at the edge.
   */
  SweepGrid(const View& view, const double corners[24], const Resolution& resolution);

  bool operator==(const SweepGrid& other) const;

  /** Nothing of the box is seen. */
  bool IsEmpty() const { return this->Size[2] == 0; }

  /** Froxels on x and y, and slices. */
  const int* GetSize() const { return this->Size; }

  bool GetIsPerspective() const { return this->IsPerspective; }

  const double* GetWorldToView() const { return this->WorldToView; }

  /** Least and largest place on x and y. */
  const double* GetWindow() const { return this->Window; }

  /** Least and largest z: what is left of those of the box. */
  double GetBegin() const { return this->Begin; }
  double GetEnd() const { return this->End; }

  /** z between one slice's middle and the next one's, and of the middle of a slice. */
  double GetSliceDistance() const { return this->SliceDistance; }
  double GetDepth(int slice) const { return this->Begin + (slice + 0.5) * this->SliceDistance; }

  /** What a place is multiplied by to give x or y, at z. */
  double GetWidth(double z) const { return this->IsPerspective ? z : 1.0; }

  /** Least and largest z of a box, given by its corners in world coordinates. */
  void FindDepths(const double corners[24], double range[2]) const;

  /** Least and largest place on x and y of a box, given by its corners in world coordinates, between two z. False:
   * none of it lies there. */
  bool FindOutline(const double corners[24], const double range[2], double outline[4]) const;

  /**
   * World coordinates to (x w, y w, z, w), row by row, with the texture coordinates x, y and z at which is kept
   * what reaches the slice in front of a point. (A point may lie anywhere in its own slice.)
   */
  void GetWorldToTexture(double matrix[16], bool isInMiddle = false) const;

private:
  bool SetDepths(const View& view, const double corners[24]);
  bool SetWindow(const View& view, const double corners[24]);
  void Divide(const Resolution& resolution);

  double WorldToView[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  bool IsPerspective = false;
  double Window[4] = { 0.0, 1.0, 0.0, 1.0 };
  double Begin = 0.0;
  double End = 0.0;
  double SliceDistance = 1.0;
  int Size[3] = { 0, 0, 0 };
};

#endif
