// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The scalars that a filter works on: one component of any array of an image, resampled to the
// grid and smoothed, with NaN where there is no value.

#ifndef ScalarSource_h
#define ScalarSource_h

#include "VoxelBox.h"

class vtkDataArray;
class vtkImageData;
class vtkUnsignedCharArray;

namespace volumeoptics
{
// Reads rows of an image. Blanked points (vtkDataSetAttributes::HIDDENPOINT), NaN and infinities
// become NaN; points that another process owns (DUPLICATEPOINT) hold valid values and are kept.
class ImageRows
{
public:
  ImageRows(vtkImageData* image, vtkDataArray* array, int component);

  const Extent& GetBox() const { return this->Box; }
  void Read(int x0, int x1, int y, int z, double* values) const;

private:
  Extent Box;
  vtkDataArray* Array;
  vtkUnsignedCharArray* Ghosts;
  int Component;
  const void* Memory; // of arrays in standard layout, else null
};

class ScalarSource
{
public:
  // smoothing: standard deviation of a Gaussian, world length; 0 for none.
  ScalarSource(const ImageGrid& grid, const ImageRows& rows, double smoothing);

  // box: of the grid's whole extent. Rows are padded by one NaN at each end.
  VoxelBox<double> Load(const Extent& box) const;

private:
  VoxelBox<double> LoadUnsmoothed(const Extent& box) const;
  void ReadResampledRow(int x0, int x1, int y, int z, double* values) const;

  const ImageGrid& Grid;
  const ImageRows& Rows;
  double Smoothing;
};
}

#endif
