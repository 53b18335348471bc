// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryLines.h"

#include "GalleryList.h"

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

LinePicture Lines(const std::string& source, int segments, double radius)
{
  LinePicture lines;
  lines.Source = source;
  lines.Segments = segments;
  lines.Radius = radius;
  return lines;
}

// The lines with one setting changed.
template <class Value>
LinePicture With(LinePicture lines, Value LinePicture::*setting, const Value& value)
{
  lines.*setting = value;
  return lines;
}

const PictureSettings RingFromAbove = ViewFrom(25.0, 50.0, 1.4);

GallerySection SpiralsSection()
{
  const PictureSettings view = ViewFrom(25.0, 30.0, 1.3);
  const LinePicture few = Lines("spirals", 100000, 0.001), many = Lines("spirals", 1000000, 0.00025);
  return { "Lines as anisotropic voxels: vortex spirals",
    "After Fig. 4 of [Schussman2004]: spirals as voxels, 256 along the longest side, that hold what the "
    "lines in "
    "them look like from every direction; and the same lines as tubes, drawn at 10 x 10 times the "
    "resolution and averaged, with the same material and light. The voxels' frame takes as long for ten "
    "times the lines.",
    4,
    { Picture("spirals-100k", "100 thousand segments, voxels", few, view,
        "Single turns are told apart; highlights follow the lines."),
      Picture("spirals-100k-tubes", "100 thousand segments, tubes", With(few, &LinePicture::AsTubes, true),
        view, "One hundred samples in each pixel."),
      Picture("spirals-1m", "1 million segments, voxels", many, view,
        "Lines a quarter as thick: shells of them, shaded as a surface of fibres is."),
      Picture("spirals-1m-tubes", "1 million segments, tubes", With(many, &LinePicture::AsTubes, true), view,
        "Tubes thinner than the samples are apart: grain and moire.") },
    false };
}

GallerySection LightSection()
{
  const LinePicture head = Lines("ring", 1000000, 0.00025);
  const LinePicture world = With(head, &LinePicture::WorldLight, { 0.0, 0.0, 1.0 });
  const PictureSettings below = ViewFrom(25.0, -50.0, 1.4);
  return { "Lines: headlight, and a light in the world",
    "After Fig. 5: 1 million segments of streamlines that the gallery traces in a flow around a ring: blue "
    "ones "
    "in bands on two tori, orange ones in their middle. The light in the world stays above when "
    "the view changes.",
    4,
    { Picture(
        "ring-headlight", "Headlight", head, RingFromAbove, "Brightest where lines run across the view."),
      Picture("ring-headlight-below", "Headlight, from below", head, below, "Lit from the eye again."),
      Picture("ring-world", "Light from above", world, RingFromAbove, "Tops are bright, undersides dark."),
      Picture("ring-world-below", "Light from above, from below", world, below,
        "The side that is seen lies in the dark.") },
    false };
}

GallerySection TypesSection()
{
  const LinePicture lines = Lines("ring", 10000000, 0.0001);
  const auto radii = [&](const std::string& name, const std::string& title, double bands, double middle,
                       const std::string& caption) {
    return Picture(
      name, title, With(lines, &LinePicture::RadiusScales, { bands, middle }), RingFromAbove, caption);
  };
  const auto opacity = [&](int percent, const std::string& caption) {
    const std::string number = std::to_string(percent);
    return Picture("ring-opacity-" + number, "Opacity times " + number + " %",
      With(lines, &LinePicture::OpacityScale, percent / 100.0), RingFromAbove, caption);
  };
  return { "Lines: radii and opacity, 10 million segments",
    "After Figs. 6 and 7: ten times as many lines in the same voxels. Line types are separate sets of "
    "coefficients: radii and opacity are factors of what is drawn, and nothing is voxelized again.",
    3,
    { radii("ring-primaries", "Primary lines alone", 0.0, 3.0,
        "The middle; the radius of the lines in bands is 0."),
      radii("ring-secondaries", "With thin secondaries", 0.06, 3.0,
        "Bands of a sixteenth of their radius give the context."),
      radii("ring-radii", "One radius", 1.0, 1.0, "The bands outnumber and hide the middle."),
      opacity(4, "Global structure: how many lines lie behind each other."), opacity(15, "Between the two."),
      opacity(60, "Local structure: the outermost lines.") },
    false };
}

GallerySection BlockSection()
{
  const LinePicture lines = Lines("ring", 1000000, 0.00025);
  PictureSettings close = ViewFrom(0.0, 0.0, 1.0);
  close.Camera.FocalPoint = { 0.34, -0.73, 0.25 };
  close.Camera.Position = { 0.61, -1.3, 0.89 };
  close.Camera.ViewUp = { 0.0, 0.0, 1.0 };
  close.Step = 0.002;
  return { "Lines: a finer block",
    "After Fig. 7: once the whole has been seen, a block of voxels five times as fine replaces a region of "
    "it. "
    "It is made of the same lines, and takes its place by one call.",
    3,
    { Picture("block-overview", "Overview", lines, RingFromAbove, "256 voxels along the longest side."),
      Picture("block-coarse", "A region of it", lines, close, "Bands; voxels blur the lines in them."),
      Picture("block-fine", "With a finer block",
        With(lines, &LinePicture::Block, { 0.15, 0.53, -0.9, -0.52, 0.05, 0.4 }), close,
        "Single lines in the block, none beside it.") },
    false };
}
}

std::vector<GallerySection> LineSections()
{
  return { SpiralsSection(), LightSection(), TypesSection(), BlockSection() };
}
