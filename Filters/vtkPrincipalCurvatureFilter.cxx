// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPrincipalCurvatureFilter.h"

#include "AnisotropyCode.h"
#include "Batches.h"
#include "GradientTile.h"
#include "PrincipalCurvature.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPrincipalCurvatureFilter);

namespace
{
void StoreTile(const volumeoptics::ImageGrid& grid, const volumeoptics::ScalarSource& source,
  const volumeoptics::Extent& tile, volumeoptics::Storage storage, volumeoptics::VoxelBox<float>& codes)
{
  volumeoptics::GradientTile gradients(grid, source, tile);
  for (int z = tile[4]; z <= tile[5]; ++z)
  {
    for (int y = tile[2]; y <= tile[3]; ++y)
    {
      const glm::dvec3* gradient = gradients.Row(y, z);
      const volumeoptics::HessianRow hessian(grid, gradients.GetScalars(), y, z);
      codes.SetRow(y, z, volumeoptics::NoValue<float>());
      for (int x = tile[0]; x <= tile[1]; ++x)
      {
        const volumeoptics::NormalAndMagnitude surface = volumeoptics::NormalOf(gradient[x - tile[0]]);
        if (surface.Magnitude > 0.0)
        {
          const glm::dvec3 curvature =
            volumeoptics::TangentCurvature(surface.Normal, surface.Magnitude, hessian.At(x));
          volumeoptics::EncodeAnisotropy(storage, surface.Normal,
            volumeoptics::AnisotropyOfCurvature(curvature * grid.VoxelLength), codes.At(x, y, z));
        }
      }
    }
  }
}
}

//------------------------------------------------------------------------------
vtkPrincipalCurvatureFilter::vtkPrincipalCurvatureFilter()
{
  this->Smoothing = 1.0;
}

//------------------------------------------------------------------------------
void vtkPrincipalCurvatureFilter::GetReach(const volumeoptics::ImageGrid&, int reach[3])
{
  // The stencil, and the neighbours of a voxel without an estimate.
  std::fill(reach, reach + 3, 2);
}

//------------------------------------------------------------------------------
bool vtkPrincipalCurvatureFilter::ComputeCodes(const volumeoptics::ImageGrid& grid,
  const volumeoptics::ImageRows& rows, vtkInformationVector**, volumeoptics::Batches& batches,
  volumeoptics::VoxelBox<float>& codes)
{
  const volumeoptics::ScalarSource source(grid, rows, this->Smoothing * grid.VoxelLength);
  const auto tiles = volumeoptics::SplitIntoTiles(codes.GetBox(), 16, 1.0e5);
  const auto storage = static_cast<volumeoptics::Storage>(this->Storage);
  return batches.Run(
    tiles.size(), 0.9, [&](long long unit) { StoreTile(grid, source, tiles[unit], storage, codes); });
}

//------------------------------------------------------------------------------
void vtkPrincipalCurvatureFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
