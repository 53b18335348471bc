// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFile.h"

#include <vtkImageConnectivityFilter.h>
#include <vtkImageDilateErode3D.h>
#include <vtkImageMask.h>
#include <vtkIntArray.h>
#include <vtkNew.h>

#include <algorithm>

namespace
{
constexpr int Margin = 2; // voxels of air kept around the region

// The part of image within extent and the margin, with extents from 0.
vtkSmartPointer<vtkImageData> Crop(vtkImageData* image, const int region[6])
{
  const int* whole = image->GetExtent();
  int extent[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = std::max(whole[2 * axis], region[2 * axis] - Margin);
    extent[2 * axis + 1] = std::min(whole[2 * axis + 1], region[2 * axis + 1] + Margin);
  }
  double origin[3];
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], origin);
  auto cropped = vtkSmartPointer<vtkImageData>::New();
  cropped->ShallowCopy(image);
  cropped->Crop(extent);
  cropped->SetExtent(0, extent[1] - extent[0], 0, extent[3] - extent[2], 0, extent[5] - extent[4]);
  cropped->SetOrigin(origin);
  return cropped;
}
}

vtkSmartPointer<vtkImageData> IsolateLargestRegion(vtkImageData* image, double threshold)
{
  const double* range = image->GetScalarRange();
  vtkNew<vtkImageConnectivityFilter> region;
  region->SetInputData(image);
  region->SetScalarRange(threshold, range[1]);
  region->SetExtractionModeToLargestRegion();
  region->GenerateRegionExtentsOn();
  region->SetLabelModeToConstantValue();
  region->SetLabelConstantValue(1);
  region->SetLabelScalarTypeToUnsignedChar();

  vtkNew<vtkImageDilateErode3D> grown;
  grown->SetInputConnection(region->GetOutputPort());
  grown->SetKernelSize(2 * Margin + 1, 2 * Margin + 1, 2 * Margin + 1);
  grown->SetDilateValue(1);
  grown->SetErodeValue(0);

  vtkNew<vtkImageMask> isolated;
  isolated->SetImageInputData(image);
  isolated->SetInputConnection(1, grown->GetOutputPort());
  isolated->SetMaskedOutputValue(range[0]);
  isolated->Update();
  int extent[6];
  std::copy_n(region->GetExtractedRegionExtents()->GetPointer(0), 6, extent);
  return Crop(isolated->GetOutput(), extent);
}
