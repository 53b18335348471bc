// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The sampling of a filter's output: the input's, or a coarser one over the same space.

#ifndef ImageGrid_h
#define ImageGrid_h

#include <array>
#include <vector>

#include <glm/glm.hpp>

class vtkInformation;

namespace volumeoptics
{
using Extent = std::array<int, 6>;
using Halo = std::array<int, 3>;

// Output index i lies at input index i / Factor, on the same origin and axes.
struct ImageGrid
{
  Extent InputWhole;
  Extent Whole;
  double Factor;
  glm::dvec3 Spacing;         // of the output; signed, never 0
  glm::dmat3 Direction;       // index axes to world axes
  glm::dmat3 GradientToWorld; // inverse transpose of Direction
  double VoxelLength;         // finest spacing of the input along axes of two voxels or more
};

// From the pipeline information of the input. factor: in (0, 1].
ImageGrid MakeImageGrid(vtkInformation* input, double factor);

// Extent of the input that the output extent is interpolated from.
Extent InputExtent(const ImageGrid& grid, const Extent& output);

// The extent of the output over an extent of the input, up to the first voxel that lies beyond: extents that
// share their last voxels share those of the output.
Extent OutputExtent(const ImageGrid& grid, const Extent& input);

// The grid with a part of the input as its whole.
ImageGrid ClippedGrid(const ImageGrid& grid, const Extent& input);

// Voxels of the output that a world length covers along each axis; 0 along an axis of one voxel.
Halo CoveringHalo(const ImageGrid& grid, double length);

Extent Grown(const Extent& extent, const Halo& halo, const Extent& whole);
Extent Intersection(const Extent& a, const Extent& b);
bool IsEmpty(const Extent& extent);
bool Contains(const Extent& outer, const Extent& inner);
long long NumberOfVoxels(const Extent& extent);

// Boxes of sizeY x sizeZ rows over the whole x range, aligned to multiples of the sizes.
std::vector<Extent> SplitIntoTiles(const Extent& extent, int sizeY, int sizeZ);

// The same with the largest size, a power of two up to `largest`, that makes tiles of at most
// `voxels` voxels, and enough tiles to report progress often.
std::vector<Extent> SplitIntoTiles(const Extent& extent, int largest, double voxels);
}

#endif
