// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What vtkAnisotropicLineVoxelizer keeps while it goes through the pieces of its input.

#ifndef LineVoxelizerRun_h
#define LineVoxelizerRun_h

#include "Batches.h"
#include "LineAccumulator.h"
#include "ProcessGroup.h"
#include "vtkAnisotropicLineVoxelizer.h"

#include <memory>
#include <vector>

namespace volumeoptics
{
// The voxels in a box. An axis along which it has no extent gets the longest voxel's edge.
LineGrid MakeLineGrid(const int dimensions[3], const LineBounds& bounds);
}

// What lives from the first piece to the last.
struct vtkAnisotropicLineVoxelizer::Run
{
  Run(vtkAlgorithm* algorithm, const volumeoptics::ProcessGroup& processes)
    : Processes(processes)
    , Batches(algorithm)
  {
  }

  volumeoptics::ProcessGroup Processes;
  bool LooksForBounds = false;
  bool HasFailed = false; // and all processes know
  int Piece = 0;
  volumeoptics::LineBounds Bounds;
  volumeoptics::LineGrid Grid;
  std::vector<volumeoptics::LineLight> Lights;
  std::unique_ptr<volumeoptics::HarmonicBasis> Basis;
  std::unique_ptr<volumeoptics::LineAccumulator> Sums;
  volumeoptics::Batches Batches;
};

#endif
