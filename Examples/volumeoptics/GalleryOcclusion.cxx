// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryOcclusion.h"

#include "GalleryScenes.h"

namespace
{
constexpr int TracedSize = 150;
constexpr double WideAngle = 80.0, NarrowAngle = 50.0;
constexpr double WholeSphere = 180.0;
// What is seen of a flat, opaque surface is lit through the half of itself that is in front of it: at 80 degrees
// by .36 of the light, the mean of c/(1 + c) over the cone's cosines c, at 50 degrees by .45.
constexpr double Brightness = 2.4, NarrowBrightness = 1.75;
constexpr double ShadowedDiffuse = 1.6;

// Lit by ambient light alone, on a background that dark creases stand out from.
PictureSettings Ambient(PictureSettings settings)
{
  settings.Optics.Model = "none";
  settings.Function.Ambient = Brightness;
  settings.Function.Diffuse = 0.0;
  settings.Function.Specular = 0.0;
  settings.Background = { 0.45, 0.48, 0.53 };
  settings.Visibility.Samples = 16;
  return settings;
}

PictureSettings Bone()
{
  PictureSettings settings = Ambient(Cranium());
  settings.Step = 0.5;
  settings.Function.Opacity = { { -1024.0, 0.0 }, { 180.0, 0.0 }, { 330.0, 0.8 }, { 3100.0, 0.9 } };
  settings.Function.Color = { { 0.0, 1.0, 0.96, 0.88 } };
  return settings;
}

PictureSettings Skin()
{
  PictureSettings settings = Bone();
  settings.Function.Opacity = { { -1024.0, 0.0 }, { -500.0, 0.0 }, { -250.0, 0.7 }, { 3100.0, 0.9 } };
  settings.Function.Color = { { 0.0, 1.0, 0.83, 0.72 } };
  return settings;
}

PictureSettings Rings()
{
  PictureSettings settings = Ambient(MarschnerLobb());
  settings.Function.Color = { { 0.0, 1.0, 0.95, 0.85 } };
  return settings;
}

PictureSettings TubesInOneColor()
{
  PictureSettings settings = Ambient(Tubes());
  settings.Function.Opacity = { { 0.44, 0.0 }, { 0.56, 0.9 }, { 10.0, 0.9 } };
  settings.Function.Color = { { 0.0, 0.86, 0.94, 1.0 } };
  return settings;
}

PictureSettings Occluded(PictureSettings settings, double angle)
{
  settings.Visibility.OcclusionAngle = angle;
  settings.Function.Ambient = angle > NarrowAngle ? Brightness : NarrowBrightness;
  return settings;
}

// Ambient light as bright as an occluded surface's.
PictureSettings WithoutOcclusion(PictureSettings settings)
{
  settings.Function.Ambient = 1.0;
  return settings;
}

// Diffuse light from near the camera, as in the lower row of the paper's Fig. 3.
PictureSettings Lambert(PictureSettings settings)
{
  settings.Optics.Model = "vtk";
  settings.Function.Ambient = 0.0;
  settings.Function.Diffuse = 0.9;
  settings.Function.Specular = 0.0;
  settings.Lights = { { -8.0, 12.0, 1.0 } };
  return settings;
}

GalleryPicture ByDisk(PictureSettings settings, const std::string& name, const std::string& title, int size)
{
  settings.Visibility.Algorithm = "disk";
  settings.Visibility.DiskSize = size;
  const std::string grid = std::to_string(size) + " x " + std::to_string(size);
  return { name + "-disk-" + std::to_string(size), title + ", disk of " + grid, "cranium", settings,
    "The paper's recursion." };
}

GallerySection AngleSection()
{
  GallerySection section{ "Directional occlusion: how wide and how fine, cranium, CT",
    "After Fig. 5 of [Schott2009]: no light but ambient light, out of a cone about the line of sight. A wide "
    "cone "
    "lets far things darken: the orbit and the temple. The paper takes a mean over a disk again and "
    "again from slice to slice: with few points it shows their pattern, with many it takes long, and how "
    "wide its "
    "cone really is depends on the slices. 16 fixed directions of equal solid angle are near the truth and "
    "cost "
    "less.",
    3, {}, false };
  for (const double angle : { NarrowAngle, WideAngle })
  {
    const std::string degrees = std::to_string(static_cast<int>(angle));
    const std::string name = "occlusion-" + degrees, title = degrees + " degrees";
    const PictureSettings settings = Occluded(Bone(), angle);
    section.Pictures.push_back(ByDisk(settings, name, title, 2));
    section.Pictures.push_back(ByDisk(settings, name, title, 13));
    section.Pictures.push_back(
      { name + "-sweep", title + ", sweep of 16 directions", "cranium", settings, "This module's default." });
  }
  return section;
}

// A field with and without light of its own, by ambient light and by Lambert's law.
void AddPair(GallerySection& section, const std::string& name, const std::string& title,
  const std::string& field, const PictureSettings& settings)
{
  section.Pictures.push_back({ "occlusion-" + name, title + ": occlusion, 80 degrees", field,
    Occluded(settings, WideAngle), "Ambient light alone." });
  section.Pictures.push_back(
    { "occlusion-" + name + "-lambert", title + ": Lambert", field, Lambert(settings), "One lamp." });
}

GallerySection PairSection(bool withCranium)
{
  GallerySection section{ "Directional occlusion beside Lambert's law",
    "After Fig. 3: Lambert's law tells which way a surface faces, and nothing of what lies in front of it. "
    "Occlusion darkens creases, sockets and whatever lies behind something else, so that depth reads at "
    "once.",
    4, {}, false };
  if (withCranium)
  {
    AddPair(section, "bone", "Bone", "cranium", Bone());
    AddPair(section, "skin", "Skin", "cranium", Skin());
  }
  AddPair(section, "rings", "Marschner-Lobb", "marschner-lobb", Rings());
  AddPair(section, "tubes", "Vortex-like tubes", "tubes", TubesInOneColor());
  return section;
}

GallerySection TransparentSection()
{
  GallerySection section{ "Occlusion through transparent skin, and with a clipping plane",
    "After Fig. 4: transparent skin casts a weak shade onto the bone, where it is wrinkled more than "
    "elsewhere. "
    "A clipping plane takes what it removes out of the way of light, too: nothing is computed beforehand.",
    4, {}, false };
  PictureSettings layers = Ambient(Cranium());
  layers.Step = 0.5;
  layers.Function.Opacity = { { -1024.0, 0.0 }, { -450.0, 0.0 }, { -300.0, 0.05 }, { -150.0, 0.08 },
    { 60.0, 0.01 }, { 150.0, 0.01 }, { 220.0, 0.2 }, { 330.0, 0.8 }, { 3100.0, 0.9 } };
  layers.Function.Color = { { -1024.0, 1.0, 0.75, 0.62 }, { 100.0, 1.0, 0.7, 0.58 }, { 220.0, 1.0, 0.9, 0.8 },
    { 3100.0, 1.0, 0.97, 0.9 } };
  section.Pictures.push_back({ "occlusion-layers-off", "Skin over bone, no occlusion", "cranium",
    WithoutOcclusion(layers), "Ambient light alone: a flat fog." });
  section.Pictures.push_back(
    { "occlusion-layers", "Skin over bone, 80 degrees", "cranium", Occluded(layers, WideAngle), " " });
  PictureSettings open = Bone();
  open.Camera.Azimuth = -40.0;
  open.Camera.Elevation = 30.0;
  open.ClippingPlanes = { { { 0.0, 0.0, -1.0 }, { 0.5, 0.5, 0.72 } } };
  section.Pictures.push_back(
    { "occlusion-clipped-off", "Skull cut open, no occlusion", "cranium", WithoutOcclusion(open), " " });
  section.Pictures.push_back({ "occlusion-clipped", "Skull cut open, 80 degrees", "cranium",
    Occluded(open, WideAngle), "The base of the skull is open to light from above." });
  return section;
}

GalleryPicture TracedBone(const std::string& name, const std::string& title, double angle)
{
  PictureSettings settings = Bone();
  settings.Size = { TracedSize, TracedSize };
  return { name, title, "cranium", settings, "Kept; minutes of rays, in double.", {}, angle };
}

GallerySection TracedSection()
{
  GallerySection section{ "Directional occlusion against rays",
    "After Fig. 2, 150 x 150 pixels: light from everywhere, light out of a cone of 80 degrees about the line "
    "of "
    "sight, both by rays from each sample, and the cone by the sweep, in a fraction of a second.",
    3, {}, false };
  section.Pictures.push_back(TracedBone("traced-isotropic", "Rays, isotropic phase function", WholeSphere));
  section.Pictures.push_back(TracedBone("traced-cone", "Rays, cone of 80 degrees", WideAngle));
  PictureSettings sweep = Occluded(Bone(), WideAngle);
  sweep.Size = { TracedSize, TracedSize };
  section.Pictures.push_back({ "traced-sweep", "Sweep of 16 directions, 80 degrees", "cranium", sweep, " " });
  return section;
}

PictureSettings Shadowed(PictureSettings settings, double angle)
{
  settings = Lambert(settings);
  settings.Lights = { { -45.0, 40.0, 1.0 } };
  settings.Visibility.Shadows = angle >= 0.0;
  settings.Visibility.GridSize = 256; // an edge of a hard shadow shows froxels
  // as with occlusion: of what reaches a surface its own front takes a part
  settings.Function.Diffuse = settings.Visibility.Shadows ? ShadowedDiffuse : 0.8;
  settings.Function.Ambient = 0.12; // so that what lies in the shadow is seen
  settings.Visibility.ShadowAngle = angle > 0.0 ? angle : 0.0;
  return settings;
}

GallerySection ShadowSection(bool withCranium)
{
  GallerySection section{ "Shadows, hard and soft",
    "The same sweep from a lamp gives its shadow; a cone about the way to the lamp gives that of a lamp with "
    "an extent. One lamp, from above on the left, and a little ambient light.",
    3, {}, false };
  const auto add = [&](const std::string& name, const std::string& title, const std::string& field,
                     const PictureSettings& settings) {
    section.Pictures.push_back(
      { "shadow-" + name + "-off", title + ", no shadows", field, Shadowed(settings, -1.0), " " });
    section.Pictures.push_back(
      { "shadow-" + name + "-hard", title + ", hard", field, Shadowed(settings, 0.0), " " });
    section.Pictures.push_back(
      { "shadow-" + name + "-soft", title + ", soft: 15 degrees", field, Shadowed(settings, 15.0), " " });
  };
  if (withCranium)
  {
    add("bone", "Bone", "cranium", Bone());
  }
  add("tubes", "Vortex-like tubes", "tubes", TubesInOneColor());
  return section;
}
}

std::vector<GallerySection> OcclusionSections(bool withCranium)
{
  std::vector<GallerySection> sections = { PairSection(withCranium), ShadowSection(withCranium) };
  if (withCranium)
  {
    sections.push_back(AngleSection());
    sections.push_back(TransparentSection());
    sections.push_back(TracedSection());
  }
  return sections;
}
