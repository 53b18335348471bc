// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Rays whose integral goes by segments between two samples: in data space, pre-integrated, or with
// isosurfaces.

#ifndef SegmentRay_h
#define SegmentRay_h

#include "RayCaster.h"

namespace reference
{
bool GoesBySegments(const Scene& scene);

// Segments end at the samples of the scene and where the ray leaves the volume; the first begins where it
// enters.
glm::dvec4 IntegrateSegments(const Scene& scene, const Ray& ray);
}

#endif
