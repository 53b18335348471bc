// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the gallery shows: sections of pictures, after the figures of the papers.

#ifndef GalleryList_h
#define GalleryList_h

#include "GalleryLines.h"
#include "PictureSettings.h"

#include <string>
#include <vector>

struct GalleryPicture
{
  std::string Name;  // of the file, unique
  std::string Title; // above the numbers
  std::string Field; // see GalleryField()
  PictureSettings Settings;
  std::string Caption = "";  // what to see; empty: the settings of the reflectance
  double TracedAngle = -1.0; // above 0: a kept picture, traced by rays out of a cone of this half angle
  std::string Caption = "";  // what to see; empty: the settings of the reflectance
  LinePicture Lines = {};    // in place of the field, where it has a source
};

struct GallerySection
{
  std::string Title;
  std::string Text;
  std::size_t Columns = 3;
  std::vector<GalleryPicture> Pictures;
  bool HasScores = true; // against the phase function alone
};

std::vector<GallerySection> GalleryList(bool withCranium);

// Of the list: the integral in data space.
std::vector<GallerySection> IntegrationSections(bool withCranium);

#endif
