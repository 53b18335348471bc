// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The volumes of the gallery by name: cranium, marschner-lobb, sphere, ellipsoid, cylinder, packed,
// tubes, plant, coulomb, orbital, bucky-tetrahedra.

#ifndef GalleryField_h
#define GalleryField_h

#include "VolumeFile.h"

#include <string>

// Change it with the fields: pictures of other versions are drawn again.
constexpr int GalleryFieldVersion = 1;

Volume GalleryField(const std::string& name, const std::string& craniumFile);

#endif
