// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ScoreScenes.h"

#include "GalleryScenes.h"

#include <vtkMath.h>

#include <array>

namespace
{
constexpr int ScorePictureSize = 256;

// Blinn-Phong, Ward, Lafortune.
std::vector<ScoreModel> ScoreModels(const std::string& rule, double exponent)
{
  const double gamma = rule == "gamma-40" ? 40.0 : 10.0;
  std::vector<ScoreModel> models = { { BlinnPhongOf(exponent) }, { WardOf(exponent, gamma) },
    { LafortuneOf(exponent, gamma) } };
  if (rule == "as-printed")
  {
    models[1].Optics.Glossiness = 0.2;
    models[2].Optics.Glossiness = exponent;
  }
  if (rule == "equal-peaks")
  {
    const double roughness = models[1].Optics.Glossiness;
    models[1].Highlights = 4.0 * vtkMath::Pi() * roughness * roughness;
  }
  return models;
}
}

std::vector<std::string> ScoreRules()
{
  return { "equal-size", "gamma-40", "as-printed", "equal-peaks", "paper-weights", "saturated" };
}

std::vector<ScoreScene> ScoreScenes(bool withCranium, const std::string& rule)
{
  const std::vector<ScoreModel> high = ScoreModels(rule, HighGlossiness);
  std::vector<ScoreScene> scenes;
  if (withCranium)
  {
    scenes = { { "Cranium, high glossiness", "cranium", Cranium(), high, {} },
      { "Cranium, low glossiness", "cranium", Cranium(), ScoreModels(rule, LowGlossiness), {} } };
  }
  const std::vector<ScoreScene> fields = { { "Marschner-Lobb", "marschner-lobb", MarschnerLobb(), high, {} },
    { "Ellipsoid", "ellipsoid", Primitive(), high, {} },
    { "Packed ellipsoids", "packed", PackedEllipsoids(), high, {} },
    { "Vortex tubes", "tubes", Tubes(), high, {} } };
  scenes.insert(scenes.end(), fields.begin(), fields.end());
  const AmbientSettings sampling = Cranium().Ambient;
  for (ScoreScene& scene : scenes)
  {
    scene.Settings.Size = { ScorePictureSize, ScorePictureSize };
    scene.Settings.Ambient = sampling;
    if (rule == "paper-weights")
    {
      scene.Settings.Function.Specular = 4.0 * vtkMath::Pi() * scene.Settings.Function.Diffuse;
    }
    if (rule == "saturated")
    {
      scene.Settings.Function.Specular = 64.0;
    }
    const CameraSettings front = scene.Settings.Camera;
    for (const auto& [azimuth, elevation] :
      { std::array<double, 2>{ 0.0, 0.0 }, { 40.0, 0.0 }, { -40.0, 10.0 }, { 80.0, 5.0 }, { 0.0, 30.0 } })
    {
      CameraSettings view = front;
      view.Azimuth += azimuth;
      view.Elevation += elevation;
      scene.Views.push_back(view);
    }
  }
  return scenes;
}
