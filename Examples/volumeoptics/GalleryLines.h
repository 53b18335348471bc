// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sections of the gallery on lines as anisotropic voxels, after the figures of [Schussman2004].

#ifndef GalleryLines_h
#define GalleryLines_h

#include "TransferFunction.h"

#include <array>
#include <string>
#include <vector>

// A picture of lines that the gallery makes. JSON is the key of the cache.
struct LinePicture
{
  std::string Source; // spirals, ring; empty: the picture is that of a volume
  int Segments = 0;
  double Radius = 0.001;
  int Grid = 256;
  bool AsTubes = false;                                 // at ten times the resolution
  std::array<double, 3> WorldLight = { 0.0, 0.0, 0.0 }; // direction to it; 0: a headlight
  std::array<double, 2> RadiusScales = { 1.0, 1.0 };    // of the line types 0 and 1
  double OpacityScale = 1.0;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
  LinePicture, Source, Segments, Radius, Grid, AsTubes, WorldLight, RadiusScales, OpacityScale)

struct GallerySection;

std::vector<GallerySection> LineSections();

#endif
