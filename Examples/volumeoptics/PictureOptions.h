// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Options of the command line that fill PictureSettings, shared by render and view.

#ifndef PictureOptions_h
#define PictureOptions_h

#include "IntegrationOptions.h"
#include "PictureSettings.h"
#include "VolumeFile.h"

#include <CLI/CLI.hpp>

#include <string>

struct PictureOptions
{
  PictureOptions();
  virtual ~PictureOptions() = default;

  PictureSettings Picture;
  IntegrationOptions Integration; // over those of the transfer function
  std::string File;
  std::string FunctionFile;
  std::string PresetName;
  std::string LightingFile;
  std::string SizeText = "1024x1024";
  std::string BackgroundText = "white";
  std::string AmbientColorText = "white";
  std::vector<double> CameraValues; // azimuth, elevation, roll, zoom
  std::vector<double> LightValues;  // azimuth, elevation
  bool Headless = false;

  void AddTo(CLI::App& command);
  // Occlusion and shadows alone.
  void AddVisibilityTo(CLI::App& command);
  // Camera, size, light, step and background alone.
  void AddViewTo(CLI::App& command);
  // Completes Picture by what the view's options say.
  void CompleteView();
  // Throws UserError, with the remedy, where settings contradict each other.
  void Check() const;
  // Reads the file and completes Picture by what depends on it. Throws UserError.
  Volume Load();
  // The option that names LightingFile.
  virtual CLI::Option* AddLightingFile(CLI::App& command);
};

#endif
