// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockCropping.h"

namespace volumeoptics
{
namespace
{
const int BlockRegion = 13; // of 27, x fastest
}

BlockCropping::BlockCropping()
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { static_cast<BlockCropping*>(client)->Update(); });
}

BlockCropping::~BlockCropping()
{
  this->Follow(nullptr);
}

void BlockCropping::Follow(vtkCamera* camera)
{
  if (this->Camera)
  {
    this->Camera->RemoveObserver(this->Command);
  }
  this->Camera = camera;
  if (camera)
  {
    camera->AddObserver(vtkCommand::ModifiedEvent, this->Command);
    this->Update();
  }
}

void BlockCropping::Set(const Box& block, vtkVolumeMapper* behind, vtkVolumeMapper* inFront)
{
  this->Clear();
  this->Block = block;
  this->Behind = behind;
  this->InFront = inFront;
  for (vtkVolumeMapper* mapper : { behind, inFront })
  {
    if (mapper)
    {
      mapper->SetCroppingRegionPlanes(this->Block.data());
      mapper->CroppingOn();
    }
  }
  this->Update();
}

void BlockCropping::Clear()
{
  for (vtkWeakPointer<vtkVolumeMapper>* mapper : { &this->Behind, &this->InFront })
  {
    if (*mapper)
    {
      (*mapper)->CroppingOff();
    }
    *mapper = nullptr;
  }
}

// A ray that begins beyond a face leaves the half space there before it may meet the block, and does not come back.
std::array<int, 3> BlockCropping::FirstRegions() const
{
  double position[3], direction[3];
  this->Camera->GetPosition(position);
  this->Camera->GetDirectionOfProjection(direction);
  const bool isParallel = this->Camera->GetParallelProjection() != 0;
  std::array<int, 3> regions = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isBelow = isParallel ? direction[axis] > 0.0 : position[axis] < this->Block[2 * axis];
    const bool isAbove = isParallel ? direction[axis] < 0.0 : position[axis] > this->Block[2 * axis + 1];
    regions[axis] = isBelow ? 0 : isAbove ? 2 : 1;
  }
  return regions;
}

void BlockCropping::Update()
{
  if (!this->Camera || (!this->Behind && !this->InFront))
  {
    return;
  }
  const std::array<int, 3> first = this->FirstRegions();
  int before = 0, after = 0;
  for (int region = 0; region < 27; ++region)
  {
    const int place[3] = { region % 3, region / 3 % 3, region / 9 };
    bool isBefore = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      isBefore = isBefore || (first[axis] != 1 && place[axis] == first[axis]);
    }
    before |= isBefore ? 1 << region : 0;
    after |= isBefore || region == BlockRegion ? 0 : 1 << region;
  }
  if (this->InFront)
  {
    this->InFront->SetCroppingRegionFlags(before);
  }
  if (this->Behind)
  {
    this->Behind->SetCroppingRegionFlags(after);
  }
}
}
