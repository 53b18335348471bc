// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scalars of a tile with their neighbours, and their Sobel gradients row by row.

#ifndef GradientTile_h
#define GradientTile_h

#include "ScalarSource.h"
#include "SobelStencil.h"

namespace volumeoptics
{
class GradientTile
{
public:
  // box: of the grid's whole extent.
  GradientTile(const ImageGrid& grid, const ScalarSource& source, const Extent& box)
    : Box(box)
    , Stencil(grid)
    , Scalars(source.Load(Grown(box, { 1, 1, 1 }, grid.Whole)))
    , Gradients(box[1] - box[0] + 1)
  {
  }

  const VoxelBox<double>& GetScalars() const { return this->Scalars; }

  // In world axes, valid until the next call; 0 where there is none.
  const glm::dvec3* Row(int y, int z)
  {
    this->Stencil.Row(this->Scalars, this->Box[0], this->Box[1], y, z, this->Gradients.data());
    return this->Gradients.data();
  }

private:
  Extent Box;
  SobelStencil Stencil;
  VoxelBox<double> Scalars;
  std::vector<glm::dvec3> Gradients;
};
}

#endif
