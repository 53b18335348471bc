// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Draws the gallery's pictures, and remembers what was drawn with which settings.

#ifndef GalleryStudio_h
#define GalleryStudio_h

#include "GalleryLines.h"
#include "PictureSettings.h"
#include "VolumeFile.h"

#include <memory>
#include <string>

class LineStudio;
class VolumeScene;

struct PictureResult
{
  std::string File; // relative to the gallery's folder
  double PreparationSeconds = 0.0;
  double FrameSeconds = 0.0;
  std::string Reference; // file of the picture with the phase function alone
  double Score = 0.0;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PictureResult, File, PreparationSeconds, FrameSeconds, Reference, Score)

class GalleryStudio
{
public:
  GalleryStudio(const std::string& folder, const std::string& cranium, bool headless, bool force);
  ~GalleryStudio();

  enum Timing
  {
    Untimed,
    Timed // draws twice: the first frame includes the preparation
  };

  // Draws the picture and its reference, unless both are there with the same settings.
  PictureResult Draw(
    const std::string& name, const std::string& field, const PictureSettings& picture, Timing timing = Timed);
  // Without the reference, for pictures that the score says nothing about.
  PictureResult DrawUnscored(
    const std::string& name, const std::string& field, const PictureSettings& picture);
  // A picture that was traced by rays and is kept with the program.
  PictureResult Keep(const std::string& name);
  // Lines, for which PreparationSeconds is the time to make their voxels.
  PictureResult DrawLines(const std::string& name, const LinePicture& lines, const PictureSettings& picture);
  // OpenGL's name of the machine that drew the latest picture; remembered with the pictures.
  std::string GetRendererName() const;
  int GetNumberOfPicturesDrawn() const { return this->NumberOfPicturesDrawn; }

private:
  PictureResult DrawOnly(
    const std::string& file, const std::string& field, const PictureSettings& picture, Timing timing);
  VolumeScene& Stage(const std::string& field);
  bool IsKnown(const std::string& file, const nlohmann::json& key) const;
  void Keep(const std::string& file, const nlohmann::json& key, const PictureResult& result,
    const std::string& renderer);
  void Remember();

  std::string Folder, CraniumFile;
  bool Headless, Force;
  std::string StagedField;
  std::unique_ptr<VolumeScene> Staged;
  std::unique_ptr<LineStudio> Lines;
  nlohmann::json Known; // file -> { settings, result }
  int NumberOfPicturesDrawn = 0;
};

#endif
