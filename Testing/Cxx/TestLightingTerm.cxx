// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TestScene.h"
int TestLightingTerm(int, char*[]) { return 0; }
