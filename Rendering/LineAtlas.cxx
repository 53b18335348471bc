// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineAtlas.h"

#include <cmath>

using volumeoptics::LineGrid;
using volumeoptics::LineVoxels;

namespace
{
glm::ivec3 CornerOffset(int corner)
{
  return glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
}

// The tiles that need a voxel: of its own brick, and of those before it on whose last faces it lies; a set of
// bits, one for each corner of a cube of two bricks an edge.
int TilesOfVoxel(const LineGrid& grid, int place)
{
  const glm::ivec3 voxel = grid.VoxelAt(0, place);
  int tiles = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 offset = CornerOffset(corner);
    tiles |= glm::all(glm::lessThanEqual(voxel * offset, glm::ivec3(0))) ? 1 << corner : 0;
  }
  return tiles;
}

int TilesOfBrick(const LineVoxels& voxels, int index, const std::vector<int>& tilesOfVoxel)
{
  int tiles = 0;
  for (const volumeoptics::LineCoefficients& set : voxels.Types)
  {
    for (vtkTypeInt64 voxel = set.BrickStarts[index]; voxel < set.BrickStarts[index + 1]; ++voxel)
    {
      tiles |= tilesOfVoxel[set.Places[voxel]];
    }
  }
  return tiles;
}
}

//------------------------------------------------------------------------------
LineAtlas::LineAtlas(const LineVoxels& voxels)
  : TileSize(voxels.Grid.Brick + 1)
{
  const LineGrid& grid = voxels.Grid;
  std::vector<int> tilesOfVoxel;
  for (int place = 0; place < grid.VoxelsOfBrick(); ++place)
  {
    tilesOfVoxel.push_back(TilesOfVoxel(grid, place));
  }
  std::vector<bool> isNeeded(grid.NumberOfBricks(), false);
  for (long long brick = 0; brick < grid.NumberOfBricks(); ++brick)
  {
    const int index = voxels.BrickIndices[brick];
    const int tiles = index < 0 ? 0 : TilesOfBrick(voxels, index, tilesOfVoxel);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 first = grid.FirstVoxelOf(brick) - CornerOffset(corner) * grid.Brick;
      if ((tiles >> corner & 1) != 0 && glm::all(glm::greaterThanEqual(first, glm::ivec3(0))))
      {
        isNeeded[grid.BrickOf(first)] = true;
      }
    }
  }
  for (long long brick = 0; brick < grid.NumberOfBricks(); ++brick)
  {
    if (isNeeded[brick])
    {
      this->Tiles.push_back(brick);
    }
  }
  const double texels = static_cast<double>(this->TileSize.x) * this->TileSize.y * this->TileSize.z;
  const double edge = std::sqrt(texels * static_cast<double>(this->Tiles.size()));
  this->TilesPerRow = std::max(1, static_cast<int>(std::ceil(edge / (this->TileSize.x * this->TileSize.z))));
}

//------------------------------------------------------------------------------
glm::ivec2 LineAtlas::Size() const
{
  const long long rows =
    (static_cast<long long>(this->Tiles.size()) + this->TilesPerRow - 1) / this->TilesPerRow;
  return glm::ivec2(this->TileSize.x * this->TileSize.z * this->TilesPerRow, this->TileSize.y * rows);
}

//------------------------------------------------------------------------------
glm::ivec2 LineAtlas::TexelOf(long long tile) const
{
  return glm::ivec2(this->TileSize.x * this->TileSize.z * (tile % this->TilesPerRow),
    this->TileSize.y * (tile / this->TilesPerRow));
}
