// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the structural scores are measured on.

#ifndef ScoreScenes_h
#define ScoreScenes_h

#include "PictureSettings.h"

#include <string>
#include <vector>

struct ScoreModel
{
  OpticsSettings Optics;
  double Highlights = 1.0; // factor of the specular coefficient
};

// A scene of the metric's report: one setting, seen from several sides by several models.
struct ScoreScene
{
  std::string Name;
  std::string Field;
  PictureSettings Settings;       // of what all models share
  std::vector<ScoreModel> Models; // Blinn-Phong, Ward, Lafortune
  std::vector<CameraSettings> Views;
};

// How the glossiness of the three models is matched, and how bright highlights are: docs/scores.md. The
// gallery reports the first, which was fixed before any measurement, and the last.
//   equal-size   one size of highlight on a sphere: exponent n of Blinn-Phong, n/4 of Lafortune,
//                sqrt(2/n) of Ward; n = 80, or 10 where glossiness is low; gamma 10
//   gamma-40     the same with gamma 40
//   as-printed   Lafortune with Blinn-Phong's exponent, Ward with 0.2, as in the paper's figures
//   equal-peaks  Ward's isotropic peak as high as the others'
//   paper-weights  equal-size, with highlights 4 pi times the diffuse coefficient: the paper's phase
//                function integrates to 1 where VTK's integrates to 4 pi, and its kd is 1
//   saturated    equal-size, with highlights so bright (64 times) that all of them are white
std::vector<std::string> ScoreRules();
std::vector<ScoreScene> ScoreScenes(bool withCranium, const std::string& rule);

#endif
