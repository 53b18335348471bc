// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFile.h"

#include <vtkImageConnectivityFilter.h>
#include <vtkImageDilateErode3D.h>
#include <vtkImageMask.h>
#include <vtkNew.h>

namespace
{
constexpr int Margin = 2; // voxels of air kept around the region
}

vtkSmartPointer<vtkImageData> IsolateLargestRegion(vtkImageData* image, double threshold)
{
  const double* range = image->GetScalarRange();
  vtkNew<vtkImageConnectivityFilter> region;
  region->SetInputData(image);
  region->SetScalarRange(threshold, range[1]);
  region->SetExtractionModeToLargestRegion();
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
  return isolated->GetOutput();
}
