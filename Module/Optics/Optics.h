// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas of Module/Optics/*.glsl for C++, in double: the very text that the GPU compiles.
// (Float: Testing/Cxx/OpticsFloat.h, from copies whose literals carry an f.)
// Everything is in an anonymous namespace, so that each file that includes this has its own.

#ifndef Optics_h
#define Optics_h

#include <glm/glm.hpp>

#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#endif

namespace
{
namespace optics
{
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using namespace glm;

#define float double
#include "PhaseFunction.glsl"
#include "Opacity.glsl"
#include "DataSpace.glsl"
#include "AnisotropyFrame.glsl"
#include "Reflectance.glsl"
#include "SoftRange.glsl"
#include "MultiSampleRule.glsl"
#include "HybridNormal.glsl"
#include "SphericalHarmonics.glsl"
#include "CylinderLighting.glsl"
#include "Visibility.glsl"
#include "LineVoxel.glsl"
#undef float
}
}

#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

#endif
