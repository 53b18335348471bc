// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A TestScene of fewer pixels, where a test draws many and none of them is about a pixel's width.

#ifndef SmallScene_h
#define SmallScene_h

#include "TestScene.h"

namespace
{
struct SmallScene : TestScene
{
  explicit SmallScene(vtkGPUVolumeRayCastMapper* mapper = nullptr)
    : TestScene(mapper)
  {
    this->Window->SetSize(48, 48);
  }
};
}

#endif
