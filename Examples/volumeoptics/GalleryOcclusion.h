// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The sections of the gallery on directional occlusion [Schott2009] and shadows.

#ifndef GalleryOcclusion_h
#define GalleryOcclusion_h

#include "GalleryList.h"

#include <vector>

std::vector<GallerySection> OcclusionSections(bool withCranium);

#endif
