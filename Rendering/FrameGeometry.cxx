// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameGeometry.h"

#include "vtkAmbientCovarianceFilter.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

namespace
{
// The grid, without arrays, of frames of a volume at a resolution factor.
vtkSmartPointer<vtkImageData> FrameGridOf(vtkImageData* volume, double factor)
{
  vtkNew<vtkAmbientCovarianceFilter> filter;
  filter->SetInputData(volume);
  filter->SetResolutionFactor(factor);
  filter->UpdateInformation();
  vtkInformation* information = filter->GetOutputInformation(0);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  image->CopyInformationFromPipeline(information);
  return image;
}
}

//------------------------------------------------------------------------------
bool HaveSameGrid(vtkImageData* first, vtkImageData* second)
{
  int a[6], b[6];
  first->GetExtent(a);
  second->GetExtent(b);
  bool same = std::equal(a, a + 6, b);
  for (int corner = 0; corner < 8 && same; ++corner)
  {
    double point[3], index[3];
    const int ijk[3] = { a[corner & 1], a[2 + (corner >> 1 & 1)], a[4 + (corner >> 2 & 1)] };
    first->TransformIndexToPhysicalPoint(ijk, point);
    second->TransformPhysicalPointToContinuousIndex(point, index);
    for (int axis = 0; axis < 3; ++axis)
    {
      same = same && std::abs(index[axis] - ijk[axis]) < 1.0e-3;
    }
  }
  return same;
}

//------------------------------------------------------------------------------
double FactorBetween(vtkImageData* volume, vtkImageData* image)
{
  const double ratio = volume->GetSpacing()[0] / image->GetSpacing()[0];
  const double factor = std::abs(ratio - 1.0) < 1.0e-6 ? 1.0 : ratio;
  const bool isPossible = factor >= SmallestResolutionFactor && factor <= 1.0;
  return isPossible && HaveSameGrid(image, FrameGridOf(volume, factor)) ? factor : 0.0;
}

//------------------------------------------------------------------------------
void MakeCentresPoints(vtkImageData* source, vtkImageData* points)
{
  int extent[6];
  source->GetExtent(extent);
  double centre[3];
  source->TransformContinuousIndexToPhysicalPoint(0.5, 0.5, 0.5, centre);
  points->SetOrigin(centre);
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis + 1] = std::max(extent[2 * axis], extent[2 * axis + 1] - 1);
  }
  points->SetExtent(extent);
}
