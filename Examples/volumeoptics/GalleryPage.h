// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// gallery/index.html: one file with the pictures beside it, no script, no network.

#ifndef GalleryPage_h
#define GalleryPage_h

#include "GalleryList.h"
#include "GalleryScores.h"
#include "GalleryStudio.h"

#include <map>
#include <string>
#include <vector>

struct GalleryContents
{
  std::vector<GallerySection> Sections;
  std::map<std::string, PictureResult> Results; // by name of the picture
  std::vector<ScoreRow> Scores;                 // empty: left out
  std::string Renderer;                         // OpenGL's name of the machine
};

void WriteGalleryPage(const std::string& folder, const GalleryContents& contents);

#endif
