// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Boxes of voxels, in bricks, and the way of a segment through them.

#ifndef LineGrid_h
#define LineGrid_h

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumeoptics
{
struct LineGrid
{
  static constexpr int LargestBrick = 8;

  glm::ivec3 Dimensions = glm::ivec3(1); // voxels
  glm::dvec3 Corner = glm::dvec3(0.0);   // of the first voxel
  glm::dvec3 Voxel = glm::dvec3(1.0);    // edges
  glm::ivec3 Brick = glm::ivec3(1);      // voxels of a brick

  glm::ivec3 Bricks() const { return (this->Dimensions + this->Brick - 1) / this->Brick; }
  int VoxelsOfBrick() const { return this->Brick.x * this->Brick.y * this->Brick.z; }
  long long NumberOfBricks() const
  {
    const glm::ivec3 bricks = this->Bricks();
    return static_cast<long long>(bricks.x) * bricks.y * bricks.z;
  }
  double Volume() const { return this->Voxel.x * this->Voxel.y * this->Voxel.z; }
  double Surface() const
  {
    return 2.0 *
      (this->Voxel.x * this->Voxel.y + this->Voxel.y * this->Voxel.z + this->Voxel.z * this->Voxel.x);
  }
  double SmallestEdge() const { return std::min(std::min(this->Voxel.x, this->Voxel.y), this->Voxel.z); }

  long long BrickOf(const glm::ivec3& voxel) const
  {
    const glm::ivec3 brick = voxel / this->Brick, bricks = this->Bricks();
    return brick.x +
      static_cast<long long>(bricks.x) * (brick.y + static_cast<long long>(bricks.y) * brick.z);
  }
  int PlaceInBrick(const glm::ivec3& voxel) const
  {
    const glm::ivec3 place = voxel % this->Brick;
    return place.x + this->Brick.x * (place.y + this->Brick.y * place.z);
  }
  glm::ivec3 FirstVoxelOf(long long brick) const
  {
    const glm::ivec3 bricks = this->Bricks();
    return glm::ivec3(brick % bricks.x, brick / bricks.x % bricks.y, brick / bricks.x / bricks.y) *
      this->Brick;
  }
  glm::ivec3 VoxelAt(long long brick, int place) const
  {
    return this->FirstVoxelOf(brick) +
      glm::ivec3(
        place % this->Brick.x, place / this->Brick.x % this->Brick.y, place / this->Brick.x / this->Brick.y);
  }
  glm::dvec3 CenterOf(const glm::ivec3& voxel) const
  {
    return this->Corner + (glm::dvec3(voxel) + 0.5) * this->Voxel;
  }
};

// Calls visit(voxel, share of the segment's length) for each voxel that the segment from a to b crosses.
// The shares add up to that of the grid.
class GridTraversal
{
public:
  GridTraversal(const LineGrid& grid, const glm::dvec3& a, const glm::dvec3& b)
    : Last(grid.Dimensions - 1)
    , Start((a - grid.Corner) / grid.Voxel)
    , Way((b - grid.Corner) / grid.Voxel - this->Start)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Clip(axis, grid.Dimensions[axis]);
    }
  }

  template <class Visit>
  void ForEachVoxel(const Visit& visit)
  {
    if (!(this->From < this->To))
    {
      return;
    }
    const glm::dvec3 entry = this->Start + this->From * this->Way;
    glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::floor(entry)), glm::ivec3(0), this->Last);
    glm::dvec3 next(this->Crossing(voxel, 0), this->Crossing(voxel, 1), this->Crossing(voxel, 2));
    for (double at = this->From; at < this->To;)
    {
      const int axis = next.x <= next.y ? (next.x <= next.z ? 0 : 2) : (next.y <= next.z ? 1 : 2);
      const double end = std::min(next[axis], this->To);
      if (end > at)
      {
        visit(voxel, end - at);
        at = end;
      }
      voxel[axis] += this->Way[axis] > 0.0 ? 1 : -1;
      if (voxel[axis] < 0 || voxel[axis] > this->Last[axis])
      {
        return;
      }
      next[axis] = this->Crossing(voxel, axis);
    }
  }

private:
  void Clip(int axis, double size)
  {
    const double start = this->Start[axis], way = this->Way[axis];
    if (way == 0.0)
    {
      this->To = start >= 0.0 && start <= size ? this->To : -1.0;
      return;
    }
    const double first = -start / way, second = (size - start) / way;
    this->From = std::max(this->From, std::min(first, second));
    this->To = std::min(this->To, std::max(first, second));
  }

  // Where the segment leaves the voxel along the axis.
  double Crossing(const glm::ivec3& voxel, int axis) const
  {
    const double way = this->Way[axis];
    const double face = voxel[axis] + (way > 0.0 ? 1 : 0);
    return way == 0.0 ? std::numeric_limits<double>::infinity() : (face - this->Start[axis]) / way;
  }

  glm::ivec3 Last;
  glm::dvec3 Start, Way;
  double From = 0.0, To = 1.0;
};
}

#endif
