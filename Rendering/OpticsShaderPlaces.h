// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where text is injected into VTK's fragment shader.

#ifndef OpticsShaderPlaces_h
#define OpticsShaderPlaces_h

#include "OpticsShaderTable.h"

struct Place
{
  const char* Tag;
  bool KeepsVTKText;        // ours is added to VTK's, or stands in its place
  bool IsBeforeVTK = false; // added before VTK's, or behind it
};

// VTK's, all of them in its raycasterfs.glsl.
inline constexpr Place BaseDec = { "//VTK::Base::Dec", true };
inline constexpr Place BaseInit = { "//VTK::Base::Init", true };
inline constexpr Place ComputeLightingDec = { "//VTK::ComputeLighting::Dec", true };
inline constexpr Place ComputeRayDirectionDec = { "//VTK::ComputeRayDirection::Dec", true };
inline constexpr Place TerminateInit = { "//VTK::Terminate::Init", true };
inline constexpr Place ClippingImpl = { "//VTK::Clipping::Impl", true };
inline constexpr Place BaseImpl = { "//VTK::Base::Impl", true, true };
inline constexpr Place ShadingInit = { "//VTK::Shading::Init", true };
inline constexpr Place ShadingImpl = { "//VTK::Shading::Impl", false };
inline constexpr Place DepthPassImpl = { "//VTK::DepthPass::Impl", true };
inline constexpr Place TerminateImpl = { "//VTK::Terminate::Impl", false };
inline constexpr Place AfterTerminateImpl = { "//VTK::Terminate::Impl", true };
// Our own, in Lighting.glsl, IntegralRay.glsl and LineShadingImpl.glsl.
inline constexpr Place GradientPlace = { "//Optics::Gradient", false };
inline constexpr Place SurfacePlace = { "//Optics::Surface", false };
inline constexpr Place LightPlace = { "//Optics::Light", false };
inline constexpr Place TransmissionPlace = { "//Optics::Transmission", false };
inline constexpr Place EndPlace = { "//Optics::End", false };
inline constexpr Place LinesPlace = { "//Optics::Lines", false };

/** What the table has for a place and a set of features. */
std::string OpticsText(const Place& place, const OpticsFeatures& features);

#endif
