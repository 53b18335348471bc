// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryLines.h"

#include "GalleryList.h"

#include <cmath>

namespace
{
constexpr int PictureSize = 416;

PictureSettings ViewFrom(double azimuth, double elevation, double zoom)
{
  PictureSettings settings;
  settings.Camera.Azimuth = azimuth;
  settings.Camera.Elevation = elevation;
  settings.Camera.Zoom = zoom;
  settings.Size = { PictureSize, PictureSize };
  settings.Background = { 0.0, 0.0, 0.0 };
  return settings;
}

GalleryPicture Picture(const std::string& name, const std::string& title, const LinePicture& lines,
  const PictureSettings& settings, const std::string& caption)
{
  GalleryPicture picture{ "lines-" + name, title, "", settings, caption };
  picture.Lines = lines;
  return picture;
}

LinePicture Spirals(int segments, double radius)
{
  LinePicture lines;
  lines.Source = "spirals";
  lines.Segments = segments;
  lines.Radius = radius;
  return lines;
}

LinePicture Ring(int segments, double radius)
{
  LinePicture lines;
  lines.Source = "ring";
  lines.Segments = segments;
  lines.Radius = radius;
  return lines;
}

LinePicture AsTubes(LinePicture lines)
{
  lines.AsTubes = true;
  return lines;
}

GallerySection SpiralsSection()
{
  GallerySection section{ "Lines as anisotropic voxels: vortex spirals",
    "After Fig. 4 of [Schussman2004]: spirals as voxels, 256 along the longest side, that hold what the "
    "lines in "
    "them look like from every direction; and the same lines as tubes, drawn at 10 x 10 times the "
    "resolution and averaged, with the same material and light. The voxels' frame takes as long for ten "
    "times the lines.",
    4, {}, false };
  const PictureSettings view = ViewFrom(25.0, 30.0, 1.3);
  const LinePicture few = Spirals(100000, 0.001), many = Spirals(1000000, 0.00025);
  section.Pictures = { Picture("spirals-100k", "100 thousand segments, voxels", few, view,
                         "Single turns are told apart; highlights follow the lines."),
    Picture("spirals-100k-tubes", "100 thousand segments, tubes", AsTubes(few), view,
      "One hundred samples in each pixel."),
    Picture("spirals-1m", "1 million segments, voxels", many, view,
      "Lines a quarter as thick: shells of them, shaded as a surface of fibres is."),
    Picture("spirals-1m-tubes", "1 million segments, tubes", AsTubes(many), view,
      "Tubes thinner than the samples are apart: grain and moire.") };
  return section;
}

GallerySection LightSection()
{
  GallerySection section{ "Lines: headlight, and a light in the world",
    "After Fig. 5: 1 million segments of streamlines that the gallery traces in a flow around a ring: blue "
    "ones "
    "in bands on two tori, orange ones in their middle. The light in the world stays above when "
    "the view changes.",
    4, {}, false };
  LinePicture lines = Ring(1000000, 0.00025);
  const PictureSettings above = ViewFrom(25.0, 50.0, 1.4), below = ViewFrom(25.0, -50.0, 1.4);
  section.Pictures.push_back(
    Picture("ring-headlight", "Headlight", lines, above, "Brightest where lines run across the view."));
  section.Pictures.push_back(
    Picture("ring-headlight-below", "Headlight, from below", lines, below, "Lit from the eye again."));
  lines.WorldLight = { 0.0, 0.0, 1.0 };
  section.Pictures.push_back(
    Picture("ring-world", "Light from above", lines, above, "Tops are bright, undersides dark."));
  section.Pictures.push_back(Picture("ring-world-below", "Light from above, from below", lines, below,
    "The side that is seen lies in the dark."));
  return section;
}

GallerySection TypesSection()
{
  GallerySection section{ "Lines: radii and opacity, 10 million segments",
    "After Figs. 6 and 7: ten times as many lines in the same voxels. Line types are separate sets of "
    "coefficients: radii and opacity are factors of what is drawn, and nothing is voxelized again.",
    3, {}, false };
  LinePicture lines = Ring(10000000, 0.0001);
  const PictureSettings view = ViewFrom(25.0, 50.0, 1.4);
  lines.RadiusScales = { 0.0, 3.0 };
  section.Pictures.push_back(Picture("ring-primaries", "Primary lines alone", lines, view,
    "The middle; the radius of the lines in bands is 0."));
  lines.RadiusScales = { 0.06, 3.0 };
  section.Pictures.push_back(Picture("ring-secondaries", "With thin secondaries", lines, view,
    "Bands of a sixteenth of their radius give the context."));
  lines.RadiusScales = { 1.0, 1.0 };
  section.Pictures.push_back(
    Picture("ring-radii", "One radius", lines, view, "The bands outnumber and hide the middle."));
  for (const double opacity : { 0.04, 0.15, 0.6 })
  {
    lines.OpacityScale = opacity;
    const std::string percent = std::to_string(std::lround(100.0 * opacity));
    section.Pictures.push_back(
      Picture("ring-opacity-" + percent, "Opacity times " + percent + " %", lines, view,
        opacity < 0.1     ? "Global structure: how many lines lie behind each other."
          : opacity < 0.2 ? "Between the two."
                          : "Local structure: the outermost lines."));
  }
  return section;
}

GallerySection BlockSection()
{
  GallerySection section{ "Lines: a finer block",
    "After Fig. 7: once the whole has been seen, a block of voxels five times as fine replaces a region of "
    "it. "
    "It is made of the same lines, and takes its place by one call.",
    3, {}, false };
  LinePicture lines = Ring(1000000, 0.00025);
  section.Pictures.push_back(Picture(
    "block-overview", "Overview", lines, ViewFrom(25.0, 50.0, 1.4), "256 voxels along the longest side."));
  PictureSettings close = ViewFrom(0.0, 0.0, 1.0);
  close.Camera.FocalPoint = { 0.34, -0.73, 0.25 };
  close.Camera.Position = { 0.61, -1.3, 0.89 };
  close.Camera.ViewUp = { 0.0, 0.0, 1.0 };
  close.Step = 0.002;
  section.Pictures.push_back(
    Picture("block-coarse", "A region of it", lines, close, "Bands; voxels blur the lines in them."));
  lines.Block = { 0.15, 0.53, -0.9, -0.52, 0.05, 0.4 };
  section.Pictures.push_back(
    Picture("block-fine", "With a finer block", lines, close, "Single lines in the block, none beside it."));
  return section;
}
}

std::vector<GallerySection> LineSections()
{
  return { SpiralsSection(), LightSection(), TypesSection(), BlockSection() };
}
