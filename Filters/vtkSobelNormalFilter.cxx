// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSobelNormalFilter.h"

#include "AnisotropyCode.h"
#include "Batches.h"
#include "GradientTile.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkSobelNormalFilter);

namespace
{
const double LargestFloat = std::numeric_limits<float>::max();

void StoreRow(const glm::dvec3* gradients, int count, int bits, float* normals, float* magnitudes)
{
  for (int i = 0; i < count; ++i)
  {
    const volumeoptics::NormalAndMagnitude surface = volumeoptics::NormalOf(gradients[i]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const float component = static_cast<float>(surface.Normal[axis]);
      normals[3 * i + axis] = volumeoptics::RoundedToBits(component, bits);
    }
    magnitudes[i] = static_cast<float>(std::min(surface.Magnitude, LargestFloat));
  }
}
}

//------------------------------------------------------------------------------
void vtkSobelNormalFilter::GetReach(const volumeoptics::ImageGrid&, int reach[3])
{
  std::fill(reach, reach + 3, 1);
}

//------------------------------------------------------------------------------
bool vtkSobelNormalFilter::ComputeArrays(const volumeoptics::ImageGrid& grid,
  const volumeoptics::ImageRows& rows, vtkInformationVector**, volumeoptics::Batches& batches,
  vtkImageData* output)
{
  const volumeoptics::ScalarSource source(grid, rows, this->Smoothing * grid.VoxelLength);
  volumeoptics::Extent extent;
  output->GetExtent(extent.data());
  float* normals = AddArray(output, "Normals", 3);
  float* magnitudes = AddArray(output, "GradientMagnitude", 1);
  output->GetPointData()->SetActiveNormals("Normals");
  const auto tiles = volumeoptics::SplitIntoTiles(extent, 32, 1.0e6);
  const int length = extent[1] - extent[0] + 1;
  return batches.Run(tiles.size(), 1.0, [&](long long unit) {
    const volumeoptics::Extent& tile = tiles[unit];
    volumeoptics::GradientTile gradients(grid, source, tile);
    for (int z = tile[4]; z <= tile[5]; ++z)
    {
      for (int y = tile[2]; y <= tile[3]; ++y)
      {
        const vtkIdType row = (y - extent[2]) + (extent[3] - extent[2] + 1LL) * (z - extent[4]);
        StoreRow(gradients.Row(y, z), length, this->OutputPrecision, normals + 3 * row * length,
          magnitudes + row * length);
      }
    }
  });
}

//------------------------------------------------------------------------------
void vtkSobelNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
