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

// A scene of the metric's report: one setting, seen from several sides by several models.
struct ScoreScene
{
  std::string Name;
  std::string Field;
  PictureSettings Settings;           // of what all models share
  std::vector<OpticsSettings> Models; // Blinn-Phong, Ward, Lafortune
  std::vector<CameraSettings> Views;
};

std::vector<ScoreScene> ScoreScenes(bool withCranium);

#endif
