// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where anisotropic voxels lie in one 2D texture. The volume is cut into bricks; a tile holds the voxels of a brick and
// the next ones beyond its last faces, so that all between the middles of its voxels is interpolated within it; its
// slices lie side by side. Bricks with nothing to interpolate have no tile.

#ifndef LineAtlas_h
#define LineAtlas_h

#include "LineVoxels.h"

#include <array>
#include <cstdint>
#include <vector>

class LineAtlas
{
public:
  static constexpr int Brick =
    4; // voxels on an axis; a smaller one has more tiles, with fewer empty voxels in each
  static constexpr int Tile = Brick + 1;
  static constexpr std::uint16_t NoTile = 65535;

  LineAtlas() = default;
  explicit LineAtlas(const volumeoptics::LineVoxels& voxels);

  glm::ivec3 Bricks = glm::ivec3(0);
  glm::ivec2 Size = glm::ivec2(0);                  // in texels
  std::vector<std::array<std::uint16_t, 4>> Voxels; // those with lines of any type
  std::vector<std::int32_t>
    Starts; // of each type's coefficients in each voxel, and the end, all types in a row
  std::vector<std::uint8_t>
    Ranks; // of each texel, in rows, which of its tile's voxels it holds, from 1 on; 0: none
  std::vector<std::int32_t> FirstSources; // of each tile, of all its voxels, in Sources
  std::vector<std::int32_t> Sources;      // numbers of voxels
  // Texel of each brick's tile, x and y; NoTile: none, and the distance, in bricks, to the next one with a tile.
  std::vector<std::uint16_t> Tiles;
  // Of each tile a bit for each cell between the middles of eight voxels, x fastest: whether one of them has lines.
  std::vector<std::uint32_t> Cells;

private:
  void ListVoxels(const volumeoptics::LineVoxels& voxels);
  void ListBrick(
    const volumeoptics::LineVoxels& voxels, long long brick, std::vector<std::vector<std::int32_t>>& starts);
  void PlaceTiles();
  void PlaceVoxels(const std::vector<int>& tileOf, int tilesPerRow);
  void MarkCells(int voxel, const std::vector<int>& tileOf);
  void ListTiles(const std::vector<int>& tileOf, int tilesPerRow);
  long long NumberOf(const glm::ivec3& brick) const;
  template <class Visit>
  void ForEachTile(int voxel, const Visit& visit) const;
};

#endif
