// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineAtlas.h"

#include "MacrocellDistances.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using volumeoptics::LineCoefficients;
using volumeoptics::LineVoxels;

namespace
{
glm::ivec2 CornerOf(int tile, int tilesPerRow)
{
  const int size = LineAtlas::Tile;
  return glm::ivec2(tile % tilesPerRow * size * size, tile / tilesPerRow * size);
}
}

//------------------------------------------------------------------------------
LineAtlas::LineAtlas(const LineVoxels& voxels)
  : Bricks((voxels.Grid.Dimensions + Brick - 1) / Brick)
{
  this->ListVoxels(voxels);
  this->PlaceTiles();
}

//------------------------------------------------------------------------------
void LineAtlas::ListVoxels(const LineVoxels& voxels)
{
  std::vector<std::vector<std::int32_t>> starts(voxels.Types.size());
  for (long long brick = 0; brick < voxels.Grid.NumberOfBricks(); ++brick)
  {
    if (voxels.BrickIndices[brick] >= 0)
    {
      this->ListBrick(voxels, brick, starts);
    }
  }
  vtkTypeInt64 before = 0; // coefficients of the types before
  for (std::size_t t = 0; t < starts.size(); ++t)
  {
    for (const std::int32_t start : starts[t])
    {
      this->Starts.push_back(static_cast<std::int32_t>(before + start));
    }
    before += voxels.Types[t].GetNumberOfCoefficients();
  }
  this->Starts.push_back(static_cast<std::int32_t>(before));
}

//------------------------------------------------------------------------------
// A type without lines in a voxel starts there where it does in the next one.
void LineAtlas::ListBrick(
  const LineVoxels& voxels, long long brick, std::vector<std::vector<std::int32_t>>& starts)
{
  const int index = voxels.BrickIndices[brick];
  const std::size_t types = voxels.Types.size();
  std::vector<vtkTypeInt64> next(types);
  for (std::size_t t = 0; t < types; ++t)
  {
    next[t] = voxels.Types[t].BrickStarts[index];
  }
  for (int place = 0; place < voxels.Grid.VoxelsOfBrick(); ++place)
  {
    const auto isHere = [&](std::size_t t) {
      const LineCoefficients& set = voxels.Types[t];
      return next[t] < set.BrickStarts[index + 1] && set.Places[next[t]] == place;
    };
    bool isOccupied = false;
    for (std::size_t t = 0; t < types; ++t)
    {
      isOccupied = isOccupied || isHere(t);
    }
    const glm::ivec3 voxel = voxels.Grid.VoxelAt(brick, place);
    isOccupied = isOccupied && glm::all(glm::lessThan(voxel, voxels.Grid.Dimensions));
    if (isOccupied)
    {
      const auto code = [](int number) { return static_cast<std::uint16_t>(number); };
      this->Voxels.push_back({ code(voxel.x), code(voxel.y), code(voxel.z), 0 });
    }
    for (std::size_t t = 0; t < types; ++t)
    {
      if (isOccupied)
      {
        starts[t].push_back(static_cast<std::int32_t>(voxels.Types[t].VoxelStarts[next[t]]));
      }
      next[t] += isHere(t) ? 1 : 0;
    }
  }
}

//------------------------------------------------------------------------------
long long LineAtlas::NumberOf(const glm::ivec3& brick) const
{
  return brick.x +
    static_cast<long long>(this->Bricks.x) * (brick.y + static_cast<long long>(this->Bricks.y) * brick.z);
}

//------------------------------------------------------------------------------
// Calls visit(brick, place in its tile) for each tile that needs the voxel: of its own brick, and of those before it
// on whose last faces it lies.
template <class Visit>
void LineAtlas::ForEachTile(int voxel, const Visit& visit) const
{
  const glm::ivec3 at(this->Voxels[voxel][0], this->Voxels[voxel][1], this->Voxels[voxel][2]);
  const glm::ivec3 own = at / Brick;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 brick = own - glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::ivec3 place = at - brick * Brick;
    if (glm::all(glm::greaterThanEqual(brick, glm::ivec3(0))) &&
      glm::all(glm::lessThan(place, glm::ivec3(Tile))))
    {
      visit(this->NumberOf(brick), place);
    }
  }
}

//------------------------------------------------------------------------------
void LineAtlas::PlaceTiles()
{
  const long long bricks = static_cast<long long>(this->Bricks.x) * this->Bricks.y * this->Bricks.z;
  const int voxels = static_cast<int>(this->Voxels.size());
  std::vector<int> tileOf(bricks, -1);
  int tiles = 0;
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    this->ForEachTile(voxel, [&](long long brick, const glm::ivec3&) {
      tiles += tileOf[brick] < 0 ? 1 : 0;
      tileOf[brick] = tileOf[brick] < 0 ? tiles - 1 : tileOf[brick];
    });
  }
  // about as wide as high
  const int perRow = std::max(1, static_cast<int>(std::ceil(std::sqrt(double(tiles) / Tile))));
  const int rows = (tiles + perRow - 1) / perRow;
  this->Size = glm::ivec2(perRow * Tile * Tile, rows * Tile);
  this->Cells.assign(std::size_t(2) * perRow * rows, 0);
  this->PlaceVoxels(tileOf, perRow);
  this->ListTiles(tileOf, perRow);
}

//------------------------------------------------------------------------------
// A tile's voxels lie one after the other, so that a byte tells them apart.
void LineAtlas::PlaceVoxels(const std::vector<int>& tileOf, int tilesPerRow)
{
  const int voxels = static_cast<int>(this->Voxels.size());
  this->FirstSources.assign(this->Cells.size() / 2 + 1, 0);
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    this->ForEachTile(
      voxel, [&](long long brick, const glm::ivec3&) { ++this->FirstSources[tileOf[brick] + 1]; });
  }
  std::partial_sum(this->FirstSources.begin(), this->FirstSources.end(), this->FirstSources.begin());
  this->Sources.assign(this->FirstSources.back(), 0);
  this->Ranks.assign(static_cast<std::size_t>(this->Size.x) * this->Size.y, 0);
  std::vector<std::int32_t> next = this->FirstSources;
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    this->ForEachTile(voxel, [&](long long brick, const glm::ivec3& place) {
      const int tile = tileOf[brick];
      const glm::ivec2 texel = CornerOf(tile, tilesPerRow) + glm::ivec2(place.x + Tile * place.z, place.y);
      const std::int32_t source = next[tile]++;
      this->Sources[source] = voxel;
      this->Ranks[texel.x + static_cast<std::size_t>(this->Size.x) * texel.y] =
        static_cast<std::uint8_t>(source - this->FirstSources[tile] + 1);
    });
    this->MarkCells(voxel, tileOf);
  }
}

//------------------------------------------------------------------------------
// A cell has the number of the first of its voxels on each axis.
void LineAtlas::MarkCells(int voxel, const std::vector<int>& tileOf)
{
  const glm::ivec3 at(this->Voxels[voxel][0], this->Voxels[voxel][1], this->Voxels[voxel][2]);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 cell = at - glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    if (glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))))
    {
      const glm::ivec3 place = cell % Brick;
      const int bit = place.x + Brick * (place.y + Brick * place.z);
      this->Cells[2 * tileOf[this->NumberOf(cell / Brick)] + bit / 32] |= 1U << bit % 32;
    }
  }
}

//------------------------------------------------------------------------------
void LineAtlas::ListTiles(const std::vector<int>& tileOf, int tilesPerRow)
{
  std::vector<unsigned char> distances(tileOf.size());
  std::transform(tileOf.begin(), tileOf.end(), distances.begin(),
    [](int tile) { return static_cast<unsigned char>(tile < 0 ? 1 : 0); });
  volumeoptics::FindMacrocellDistances(&this->Bricks.x, distances);
  for (std::size_t brick = 0; brick < tileOf.size(); ++brick)
  {
    const glm::ivec2 texel = CornerOf(tileOf[brick], tilesPerRow);
    const bool isEmpty = tileOf[brick] < 0;
    this->Tiles.push_back(isEmpty ? NoTile : static_cast<std::uint16_t>(texel.x));
    this->Tiles.push_back(isEmpty ? distances[brick] : static_cast<std::uint16_t>(texel.y));
  }
}
