// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scalars on both sides of each voxel along its gradient [Lum2004].

#ifndef GradientAlignedSampler_h
#define GradientAlignedSampler_h

#include "ScalarSource.h"
#include "SobelStencil.h"

namespace volumeoptics
{
struct GradientAlignedSample
{
  double Center;            // NaN where there is no value
  double Ahead;             // S1: uphill
  double Behind;            // S2: downhill
  double GradientMagnitude; // per world length
};

// The voxels of a tile.
class GradientAlignedSampler
{
public:
  // tile: of the grid's whole extent. step: world length.
  GradientAlignedSampler(const ImageGrid& grid, const ScalarSource& source, const Extent& tile, double step);

  // Voxels around one whose scalars are needed.
  static Halo GetReach(const ImageGrid& grid, double step);

  // The samples of a row, valid until the next call.
  const std::vector<GradientAlignedSample>& Row(int y, int z);

private:
  double Interpolate(const glm::dvec3& index) const;
  double InterpolateIncomplete(const int (&voxel)[3], const double (&weight)[3]) const;

  Extent Tile;
  glm::dmat3 StepToIndex; // of a unit vector in world axes
  SobelStencil Stencil;
  VoxelBox<double> Scalars;
  std::vector<glm::dvec3> Gradients;
  std::vector<GradientAlignedSample> Samples;
};
}

#endif
