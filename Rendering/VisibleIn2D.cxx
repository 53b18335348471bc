// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibleIn2D.h"

#include "ScalarCoordinates.h"
#include "VisibleGradients.h"
#include "VisibleScalars.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkImageData* Function2D(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetTransferFunction2D();
}

// One axis of the function and of VTK's texture, to which vtkImageResize fits it, the centres of both ends upon each
// other. Its kernel, Lanczos's, has a half-width of three texels of the coarser grid, and rings in them: where it is
// not 0 it may be seen.
struct ResizedAxis
{
  ResizedAxis(int texels, int entries, bool isResized)
    : Texels(texels)
    , Entries(entries)
    , Pitch(entries > 1 ? (texels - 1.0) / (entries - 1.0) : 1.0)
    , Reach(isResized ? 3.0 * std::max(this->Pitch, 1.0) : 0.0)
    , IsResized(isResized)
  {
  }

  // How many texels away one may be seen at a texel or between it and the next: where the texture's edges are laid upon
  // the function's, the texture is up to half a texel off, and between two of its entries it is interpolated.
  int GetTexelsAround() const
  {
    return this->IsResized ? static_cast<int>(std::ceil(this->Reach + this->Pitch + 0.5)) - 1 : 0;
  }

  // The texture's coordinate from which on a texel is seen.
  double FindBegin(int texel) const
  {
    const double entry = (texel - this->Reach) / this->Pitch - 0.5 - VisibleScalars::LookUpSlack;
    return this->Entries > 1 ? entry / this->Entries : 0.0;
  }

  int Texels;
  int Entries;
  double Pitch; // of the texture, in texels of the function
  double Reach;
  bool IsResized;
};

// Of each column the largest opacity and the first row that has one; a negative one rings, too.
void SearchColumns(vtkImageData* function, std::vector<float>& opacities, std::vector<int>& rows)
{
  const int* size = function->GetDimensions();
  const auto* texels = static_cast<const float*>(function->GetPointData()->GetScalars()->GetVoidPointer(0));
  for (int texel = 0; texel < size[0] * size[1]; ++texel)
  {
    const float opacity = std::abs(texels[4 * texel + 3]);
    const int column = texel % size[0];
    if (!(opacity <= 0.0F))
    {
      rows[column] = std::min(rows[column], texel / size[0]);
      opacities[column] = std::max(opacities[column], std::isnan(opacity) ? 1.0F : opacity);
    }
  }
}
}

//------------------------------------------------------------------------------
bool IsUsable2D(const OpticsScene& scene)
{
  vtkImageData* function = Function2D(scene);
  return function && function->GetScalarType() == VTK_FLOAT && function->GetNumberOfScalarComponents() == 4 &&
    function->GetDimensions()[0] > 1;
}

//------------------------------------------------------------------------------
Columns2D FindColumns2D(const OpticsScene& scene)
{
  const int* size = Function2D(scene)->GetDimensions();
  const int width = FindTableSize(scene, size[0]), height = size[1] > 1 ? FindTableSize(scene, size[1]) : 1;
  const bool isResized = size[0] != width || size[1] != height;
  const ResizedAxis scalars(size[0], width, isResized), gradients(size[1], height, isResized);
  std::vector<float> opacities(size[0], 0.0F);
  std::vector<int> rows(size[0], size[1]);
  SearchColumns(Function2D(scene), opacities, rows);

  Columns2D columns;
  columns.Opacities.resize(size[0]);
  columns.LeastGradients.resize(IsSeenByGradients(scene) ? size[0] : 0);
  const int around = scalars.GetTexelsAround();
  const double slack = FindGradientSlack(scene);
  for (int column = 0; column < size[0]; ++column)
  {
    const int begin = std::max(column - around, 0), end = std::min(column + around + 1, size[0]);
    columns.Opacities[column] = *std::max_element(opacities.begin() + begin, opacities.begin() + end);
    if (!columns.LeastGradients.empty())
    {
      const int row = *std::min_element(rows.begin() + begin, rows.begin() + end);
      columns.LeastGradients[column] = static_cast<float>(std::max(gradients.FindBegin(row) - slack, 0.0));
    }
  }
  return columns;
}
