// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TestScene.h"
int TestLightingExtremes(int, char*[]) { return 0; }
