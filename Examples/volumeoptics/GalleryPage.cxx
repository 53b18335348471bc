// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryPage.h"

#include "Progress.h"
#include "UserError.h"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace
{
const char* const Style = R"(
:root { color-scheme: light dark; --ink: #1c2024; --dim: #667078; --line: #d8dde1; --back: #fbfbfa; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e8ea; --dim: #98a2aa; --line: #343b41; --back: #15181b; } }
body { margin: 0 auto; max-width: 1680px; padding: 2rem; background: var(--back); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { margin: 0; font-size: 2rem; font-weight: 600; }
h2 { margin: 3rem 0 .2rem; font-size: 1.3rem; font-weight: 600; }
p { max-width: 60rem; margin: .2rem 0 1rem; color: var(--dim); }
nav a { margin-right: 1.2rem; color: inherit; }
.row { display: grid; gap: 1rem; }
figure { margin: 0; }
img { display: block; width: 100%; border: 1px solid var(--line); border-radius: 4px; }
img.enlarged { image-rendering: pixelated; }
figcaption { padding: .4rem 0; font-size: .85rem; color: var(--dim); }
figcaption b { display: block; font-size: .95rem; font-weight: 600; color: var(--ink); }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .9rem .25rem 0; border-bottom: 1px solid var(--line); text-align: right; }
th:first-child, td:first-child { text-align: left; }
.best { font-weight: 600; }
)";

std::string Number(const char* format, double value)
{
  char text[48];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string SettingsText(const PictureSettings& settings)
{
  const OpticsSettings& optics = settings.Optics;
  const AmbientSettings& ambient = settings.Ambient;
  const bool anisotropic = optics.Model == "ward" || optics.Model == "lafortune";
  std::string text = optics.Model;
  if (optics.Glossiness >= 0.0)
  {
    text += Number(", kappa %.3g", optics.Glossiness);
  }
  if (anisotropic)
  {
    text += Number(", gamma %g", optics.Anisotropy);
  }
  if (anisotropic && optics.FrameSource == "covariance")
  {
    text += Number(", r %g", ambient.Radius) +
      (ambient.Pattern == "exhaustive" ? ", all voxels" : Number(", n %g", ambient.Samples)) +
      Number(", eps %g", ambient.Tolerance);
    text += ambient.FilterStandardDeviation > 0.0
      ? Number(", filter %g voxels", ambient.FilterStandardDeviation)
      : std::string();
  }
  return text;
}

void PutPicture(std::ostream& page, const GalleryPicture& picture, const PictureResult& result)
{
  const bool isEnlarged = picture.Settings.Size[0] < 100;
  page << "<figure><a href=\"" << result.File << "\"><img" << (isEnlarged ? " class=\"enlarged\"" : "")
       << " src=\"" << result.File << "\" alt=\"" << picture.Title
       << "\" loading=\"lazy\"></a>\n<figcaption><b>" << picture.Title << "</b>"
       << (picture.Caption.empty() ? SettingsText(picture.Settings) : picture.Caption);
  if (result.FrameSeconds > 0.0)
  {
    page << "<br>frame " << TimeText(result.FrameSeconds);
  }
  if (result.PreparationSeconds > 0.0)
  {
    page << (picture.Lines.Source.empty() ? ", normals and covariance " : ", voxels from lines ")
         << TimeText(result.PreparationSeconds);
  }
  if (!result.Reference.empty())
  {
    page << ", structural score " << Number("%.4f", result.Score);
  }
  page << "</figcaption></figure>\n";
}

void PutSection(std::ostream& page, std::size_t index, const GallerySection& section,
  const std::map<std::string, PictureResult>& results)
{
  page << "<h2 id=\"s" << index << "\">" << section.Title << "</h2>\n<p>" << section.Text << "</p>\n"
       << "<div class=\"row\" style=\"grid-template-columns: repeat(" << section.Columns << ", 1fr)\">\n";
  for (const GalleryPicture& picture : section.Pictures)
  {
    PutPicture(page, picture, results.at(picture.Name));
  }
  page << "</div>\n";
}

std::string Ratio(double score, double reference)
{
  return reference > 0.0 ? Number("%.2f", score / reference) : std::string("-");
}

void PutScoreCells(std::ostream& page, const ScoreRow& row)
{
  page << "<td>" << Number("%.4f", row.BlinnPhong) << "</td><td>" << Number("%.4f", row.Ward) << "</td><td>"
       << Number("%.4f", row.Lafortune) << "</td><td>" << Ratio(row.Ward, row.BlinnPhong) << "</td><td>"
       << Ratio(row.Lafortune, row.BlinnPhong) << "</td></tr>\n";
}

const char* const ScoreHeads = "<th>Blinn-Phong</th><th>Ward</th><th>Lafortune</th>"
                               "<th>Ward / Blinn-Phong</th><th>Lafortune / Blinn-Phong</th></tr>\n";

void PutMeanScores(std::ostream& page, const std::vector<ScoreRow>& rows)
{
  page << "<table><tr><th>Rule</th><th>Scene, mean of all views</th>" << ScoreHeads;
  for (const ScoreRow& mean : MeanScores(rows))
  {
    page << "<tr><td>" << mean.Rule << "</td><td>" << mean.Scene << "</td>";
    PutScoreCells(page, mean);
  }
  page << "</table>\n";
}

void PutScores(std::ostream& page, const GalleryContents& contents)
{
  page
    << "<h2 id=\"scores\">Structural score</h2>\n<p>Multi-scale homogeneity-weighted structural "
       "dissimilarity of each picture against the phase function alone, after Table 2: more is more "
       "structure. Scenes, lights, coefficients and the sampling are the same for all models; every view is "
       "listed (<a href=\"scores.csv\">scores.csv</a>). By the rule 'equal-size', fixed before the first "
       "measurement, the models have one size of highlight on a sphere: Blinn-Phong's exponent n, "
       "Lafortune's n/4, Ward's roughness sqrt(2/n), n = 80, or 10 for low glossiness; gamma is 10. Ward's "
       "lobe is normalised, the others' are not: it is dimmer where it is wide or drawn out far, and "
       "scores less there. By 'saturated', measured later, highlights are so bright that all are white: what "
       "counts is where they reach, not how bright they are (docs/scores.md).</p>\n";
  PutMeanScores(page, contents.Scores);
  page << "<p></p><table><tr><th>Rule</th><th>Scene</th><th>View</th><th>Azimuth</th><th>Elevation</th>"
       << ScoreHeads;
  for (const ScoreRow& row : contents.Scores)
  {
    page << "<tr><td>" << row.Rule << "</td><td>" << row.Scene << "</td><td>" << row.View << "</td><td>"
         << row.Camera.Azimuth << "</td><td>" << row.Camera.Elevation << "</td>";
    PutScoreCells(page, row);
  }
  page << "</table>\n";
}
}

void WriteGalleryPage(const std::string& folder, const GalleryContents& contents)
{
  std::ostringstream page;
  page << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>VolumeOptics "
          "gallery</title>\n"
       << "<meta name=\"viewport\" content=\"width=device-width\">\n<style>" << Style
       << "</style></head><body>\n<h1>VolumeOptics</h1>\n<p>Optical models for volumes: anisotropic ambient "
          "shading, scale-invariant volume rendering, lighting transfer functions, directional occlusion. "
       << "Rendered on " << contents.Renderer << ".</p>\n<nav>";
  for (std::size_t i = 0; i < contents.Sections.size(); ++i)
  {
    page << "<a href=\"#s" << i << "\">" << contents.Sections[i].Title << "</a>";
  }
  page << "<a href=\"#scores\">Structural score</a></nav>\n";
  for (std::size_t i = 0; i < contents.Sections.size(); ++i)
  {
    PutSection(page, i, contents.Sections[i], contents.Results);
  }
  if (!contents.Scores.empty())
  {
    PutScores(page, contents);
  }
  page << "</body></html>\n";
  const std::string path = folder + "/index.html";
  if (!(std::ofstream(path) << page.str()))
  {
    throw UserError("'" + path + "' cannot be written. Check that its folder is writable.");
  }
}
