// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// This module's overrides in VTK's object factories. None is enabled until somebody asks for it.
// VTK takes the first registered factory that has an enabled override, and its own are registered
// before ours: so ours is put in front of them, and their flags are left alone.

#ifndef OpticsFactory_h
#define OpticsFactory_h

namespace OpticsFactory
{
/** Whether className::New() gives this module's class. */
void SetEnabled(const char* className, bool enabled);
bool GetEnabled(const char* className);
}

#endif
