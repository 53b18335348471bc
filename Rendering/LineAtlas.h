// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where the occupied bricks of anisotropic voxels lie in one 2D texture. A tile holds the voxels of a brick and
// the next ones beyond its last faces, so that all between the middles of its voxels is interpolated within it;
// its slices lie side by side. Bricks with nothing to interpolate have no tile.

#ifndef LineAtlas_h
#define LineAtlas_h

#include "LineVoxels.h"

#include <vector>

class LineAtlas
{
public:
  LineAtlas() = default;
  explicit LineAtlas(const volumeoptics::LineVoxels& voxels);

  glm::ivec3 TileSize = glm::ivec3(0); // in voxels
  int TilesPerRow = 1;
  std::vector<long long> Tiles; // the brick of each tile

  // In texels; wide as high, as far as whole tiles are.
  glm::ivec2 Size() const;
  glm::ivec2 TexelOf(long long tile) const;
};

#endif
