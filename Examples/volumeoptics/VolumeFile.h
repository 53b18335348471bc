// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Reads a volume from any file that VTK reads, or from a project of InVesalius.

#ifndef VolumeFile_h
#define VolumeFile_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>

struct Volume
{
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra; // drawn in place of the image, where there are some
  std::string Name;
  // Where the face looks along y: -1 as in DICOM (left, posterior, superior), +1 as in NIfTI.
  double Front = -1.0;
};

// Throws UserError. One component, the first, is left.
Volume ReadVolume(const std::string& path);

// The largest connected region above threshold (the head) and a margin around it remain; all else
// (head rest, table, hoses) becomes the least value.
vtkSmartPointer<vtkImageData> IsolateLargestRegion(vtkImageData* image, double threshold);

#endif
