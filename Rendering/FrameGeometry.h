// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where the voxels of normals and frames lie beside those of the volume.

#ifndef FrameGeometry_h
#define FrameGeometry_h

class vtkImageData;

// Of normals and frames, the least that the mapper computes at.
const double SmallestResolutionFactor = 0.0625;

// Index coordinates of one grid are those of the other, to a thousandth of a voxel.
bool HaveSameGrid(vtkImageData* first, vtkImageData* second);

// The resolution factor at which frames of a volume lie on the grid of an image; 0: there is none.
double FactorBetween(vtkImageData* volume, vtkImageData* image);

// A cell's value stands at its centre.
void MakeCentresPoints(vtkImageData* source, vtkImageData* points);

#endif
