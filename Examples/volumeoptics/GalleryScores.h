// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The metric's report: every view of every scene, none left out.

#ifndef GalleryScores_h
#define GalleryScores_h

#include "ScoreScenes.h"
#include "GalleryStudio.h"

#include <functional>
#include <string>
#include <vector>

struct ScoreRow
{
  std::string Rule; // of ScoreRules()
  std::string Scene;
  int View = 0;
  CameraSettings Camera;
  double BlinnPhong = 0.0, Ward = 0.0, Lafortune = 0.0;
};

// told: after each view.
std::vector<ScoreRow> MeasureScores(const std::string& rule, const std::vector<ScoreScene>& scenes,
  GalleryStudio& studio, const std::function<void(const std::string&)>& told);

// One row a rule and scene, in their order: the means of all views. View counts them.
std::vector<ScoreRow> MeanScores(const std::vector<ScoreRow>& rows);

void WriteScores(const std::string& path, const std::vector<ScoreRow>& rows);

#endif
