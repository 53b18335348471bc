// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What differs between the versions of VTK that the module builds with.

#ifndef VTKVersion_h
#define VTKVersion_h

#include "vtkVersionMacros.h"

// VTK 9.2 counts the lights; before, its volume mapper copied them into arrays of six on its stack.
constexpr bool VTKLimitsLights = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0);

// VTK 9.2 marches to the lights from each sample, where SetVolumetricScatteringBlending() asks for it.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
#define VOLUMEOPTICS_VTK_HAS_VOLUMETRIC_SHADOWS
#endif

// VTK 9.4 finds a window that needs no display by itself, and loads OpenGL's functions with glad.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240601)
#define VOLUMEOPTICS_VTK_HAS_HEADLESS_WINDOW
#endif

#endif
