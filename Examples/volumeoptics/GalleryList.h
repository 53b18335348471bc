// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the gallery shows: sections of pictures, after the figures of [Ament2015].

#ifndef GalleryList_h
#define GalleryList_h

#include "PictureSettings.h"

#include <string>
#include <vector>

struct GalleryPicture
{
  std::string Name;  // of the file, unique
  std::string Title; // above the numbers
  std::string Field; // see GalleryField()
  PictureSettings Settings;
};

struct GallerySection
{
  std::string Title;
  std::string Text;
  std::size_t Columns = 3;
  std::vector<GalleryPicture> Pictures;
};

std::vector<GallerySection> GalleryList(bool withCranium);

#endif
