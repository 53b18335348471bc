// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The sections of the gallery on lighting transfer functions [Lum2004].

#ifndef GalleryLighting_h
#define GalleryLighting_h

#include "GalleryList.h"

#include <vector>

std::vector<GallerySection> LightingSections(bool withCranium);

#endif
