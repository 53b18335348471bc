// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Room for a block within a volume that two mappers draw: one draws what a ray meets before the block, the other one what
// lies behind it. Both follow a camera.

#ifndef BlockCropping_h
#define BlockCropping_h

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkVolumeMapper.h"
#include "vtkWeakPointer.h"

#include <array>

namespace volumeoptics
{
class BlockCropping
{
public:
  using Box = std::array<double, 6>;

  BlockCropping();
  ~BlockCropping();
  BlockCropping(const BlockCropping&) = delete;
  void operator=(const BlockCropping&) = delete;

  void Follow(vtkCamera* camera);
  /** Both mappers crop from now on; null leaves one out. */
  void Set(const Box& block, vtkVolumeMapper* behind, vtkVolumeMapper* inFront);
  /** Both draw all again. */
  void Clear();

private:
  void Update();
  // On each axis which of the three regions, below, beside or above the block, a ray leaves before it may meet it; 1: none.
  std::array<int, 3> FirstRegions() const;

  vtkNew<vtkCallbackCommand> Command;
  vtkWeakPointer<vtkCamera> Camera;
  vtkWeakPointer<vtkVolumeMapper> Behind, InFront;
  Box Block = {};
};
}

#endif
