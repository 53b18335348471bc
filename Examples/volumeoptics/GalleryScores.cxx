// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryScores.h"

#include "CsvWriter.h"

#include <algorithm>
#include <cctype>

namespace
{
// "Cranium, high glossiness" -> "cranium-high-glossiness".
std::string FileNameOf(const std::string& title)
{
  std::string name;
  for (const unsigned char letter : title)
  {
    if (std::isalnum(letter))
    {
      name += static_cast<char>(std::tolower(letter));
    }
    else if (!name.empty() && name.back() != '-')
    {
      name += '-';
    }
  }
  return name;
}
}

std::vector<ScoreRow> MeasureScores(const std::string& rule, const std::vector<ScoreScene>& scenes,
  GalleryStudio& studio, const std::function<void(const std::string&)>& told)
{
  std::vector<ScoreRow> rows;
  for (const ScoreScene& scene : scenes)
  {
    for (std::size_t view = 0; view < scene.Views.size(); ++view)
    {
      ScoreRow row;
      row.Rule = rule;
      row.Scene = scene.Name;
      row.View = static_cast<int>(view) + 1;
      row.Camera = scene.Views[view];
      double* const scores[] = { &row.BlinnPhong, &row.Ward, &row.Lafortune };
      for (std::size_t model = 0; model < scene.Models.size(); ++model)
      {
        PictureSettings settings = scene.Settings;
        settings.Camera = row.Camera;
        settings.Optics = scene.Models[model].Optics;
        settings.Function.Specular *= scene.Models[model].Highlights;
        const std::string name = "score-" + rule + "-" + FileNameOf(scene.Name) + "-" +
          std::to_string(row.View) + "-" + settings.Optics.Model;
        *scores[model] = studio.Draw(name, scene.Field, settings, GalleryStudio::Untimed).Score;
      }
      rows.push_back(row);
      told(scene.Name);
    }
  }
  return rows;
}

std::vector<ScoreRow> MeanScores(const std::vector<ScoreRow>& rows)
{
  std::vector<ScoreRow> means;
  for (const ScoreRow& row : rows)
  {
    if (means.empty() || means.back().Scene != row.Scene || means.back().Rule != row.Rule)
    {
      means.push_back({ row.Rule, row.Scene, 0, {}, 0.0, 0.0, 0.0 });
    }
    ++means.back().View;
    means.back().BlinnPhong += row.BlinnPhong;
    means.back().Ward += row.Ward;
    means.back().Lafortune += row.Lafortune;
  }
  for (ScoreRow& mean : means)
  {
    for (double* score : { &mean.BlinnPhong, &mean.Ward, &mean.Lafortune })
    {
      *score /= mean.View;
    }
  }
  return means;
}

void WriteScores(const std::string& path, const std::vector<ScoreRow>& rows)
{
  CsvWriter csv(
    path, { "rule", "scene", "view", "azimuth", "elevation", "blinn-phong", "ward", "lafortune" });
  for (const ScoreRow& row : rows)
  {
    csv.Write(row.Rule, row.Scene, row.View, row.Camera.Azimuth, row.Camera.Elevation, row.BlinnPhong,
      row.Ward, row.Lafortune);
  }
}
