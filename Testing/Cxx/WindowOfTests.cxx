// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// With VOLUMEOPTICS_HEADLESS in the environment every test of this executable renders without a
// display; without it, in X windows. The baselines are the same.

#include "vtkHeadlessRenderWindow.h"

namespace
{
const bool Headless = vtkHeadlessRenderWindow::SetGlobalOverrideFromEnvironment();
}
