// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas of Module/Optics/*.glsl, and OpticsTable.glsl, for C++, in float, as a GPU computes them. The files are
// copies with an f on each literal, which CMakeLists.txt makes; a literal that it missed would be a
// double, and the promotion an error.

#ifndef OpticsFloat_h
#define OpticsFloat_h

#include <glm/glm.hpp>

#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#pragma GCC diagnostic error "-Wdouble-promotion"
#endif

namespace
{
namespace opticsFloat
{
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using namespace glm;

#include "OpticsFloat/PhaseFunction.glsl"
#include "OpticsFloat/Opacity.glsl"
#include "OpticsFloat/DataSpace.glsl"
#include "OpticsFloat/AnisotropyFrame.glsl"
#include "OpticsFloat/Reflectance.glsl"
#include "OpticsFloat/SoftRange.glsl"
#include "OpticsFloat/MultiSampleRule.glsl"
#include "OpticsFloat/HybridNormal.glsl"
#include "OpticsFloat/SphericalHarmonics.glsl"
#include "OpticsFloat/CylinderLighting.glsl"
#include "OpticsFloat/Visibility.glsl"
#include "OpticsFloat/LineVoxel.glsl"
#include "OpticsFloat/OpticsTable.glsl"
}
}

#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

#endif
