// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnisotropyFilter.h"

#include "ParameterRange.h"
#include "AnisotropyCode.h"
#include "Batches.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
const char* const StorageNames[] = { "Map", "Components", "World" };

// By which whoever reads the array tells Components from Map, which has as many numbers.
void NameComponents(int storage, vtkDataArray* codes)
{
  const char* const names[] = { "C11", "C12", "C22" };
  for (int i = 0; storage == vtkAnisotropyFilter::Components && i < 3; ++i)
  {
    codes->SetComponentName(i, names[i]);
  }
}
}

//------------------------------------------------------------------------------
void vtkAnisotropyFilter::SetStorage(int storage)
{
  volumeoptics::SetChoice(this, "Storage", storage, StorageNames, this->Storage);
}

//------------------------------------------------------------------------------
const char* vtkAnisotropyFilter::GetStorageAsString()
{
  return StorageNames[this->Storage];
}

//------------------------------------------------------------------------------
bool vtkAnisotropyFilter::ComputeArrays(const volumeoptics::ImageGrid& grid,
  const volumeoptics::ImageRows& rows, vtkInformationVector** inputs, volumeoptics::Batches& batches,
  vtkImageData* output)
{
  volumeoptics::Extent extent;
  output->GetExtent(extent.data());
  const int components =
    volumeoptics::NumberOfCodeComponents(static_cast<volumeoptics::Storage>(this->Storage));
  volumeoptics::VoxelBox<float> codes(volumeoptics::Grown(extent, { 1, 1, 1 }, grid.Whole), components, 0);
  if (!this->ComputeCodes(grid, rows, inputs, batches, codes))
  {
    return false;
  }
  float* numbers = AddArray(output, "AmbientCovariance", components);
  NameComponents(this->Storage, output->GetPointData()->GetArray("AmbientCovariance"));
  const auto tiles = volumeoptics::SplitIntoTiles(extent, 32, 1.0e6);
  const vtkIdType nx = extent[1] - extent[0] + 1;
  const vtkIdType ny = extent[3] - extent[2] + 1;
  return batches.Run(tiles.size(), 1.0, [&](long long unit) {
    const volumeoptics::Extent& tile = tiles[unit];
    for (int z = tile[4]; z <= tile[5]; ++z)
    {
      for (int y = tile[2]; y <= tile[3]; ++y)
      {
        float* code = numbers + components * nx * ((y - extent[2]) + ny * (z - extent[4]));
        for (int x = tile[0]; x <= tile[1]; ++x, code += components)
        {
          volumeoptics::CodeOrMeanOfNeighbours(codes, x, y, z, code);
          std::transform(code, code + components, code,
            [this](float n) { return volumeoptics::RoundedToBits(n, this->OutputPrecision); });
        }
      }
    }
  });
}

//------------------------------------------------------------------------------
void vtkAnisotropyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Storage: " << this->GetStorageAsString() << "\n";
}
