// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryList.h"

#include "GalleryLighting.h"
#include "GalleryOcclusion.h"
#include "GalleryScenes.h"

#include <cstdio>

namespace
{
constexpr int StudySize = 288;
constexpr int FarSize = 48;

GalleryPicture Picture(const std::string& name, const std::string& title, const std::string& field,
  PictureSettings settings, const OpticsSettings& optics, double highlights = 1.0)
{
  settings.Optics = optics;
  settings.Function.Specular *= highlights;
  std::string note;
  if (highlights != 1.0)
  {
    char text[48];
    std::snprintf(text, sizeof(text), ", highlights %g times as strong", highlights);
    note = text;
  }
  return { name, title + note, field, settings };
}

GallerySection CraniumSection()
{
  GallerySection section{ "Cranium, CT",
    "Bone opaque, skin translucent; a head of the Debian package invesalius-examples. Blinn-Phong leaves "
    "round patches where the surface happens to face the half vector. With anisotropy highlights are drawn "
    "out along the rim of the orbit, the zygomatic arch, the temporal line and the jaw. The three models "
    "have the same size of highlight on a sphere: low is Blinn-Phong's exponent 10, high is 80.",
    4, {} };
  PictureSettings settings = Cranium();
  settings.Step = 0.45;
  const auto add = [&](const std::string& name, const std::string& title, const OpticsSettings& optics,
                     double highlights = 1.0) {
    section.Pictures.push_back(Picture("cranium-" + name, title, "cranium", settings, optics, highlights));
  };
  add("vtk", "Stock VTK shading", Model("vtk"));
  add("blinn-phong-low", "Blinn-Phong, low glossiness", BlinnPhongOf(LowGlossiness), 0.5);
  add("ward-low", "Ward, low glossiness", WardOf(LowGlossiness, 10.0));
  add("lafortune-low", "Lafortune, low glossiness", LafortuneOf(LowGlossiness, 10.0), 0.5);
  add("none", "Phase function alone", Model("none"));
  add("blinn-phong-high", "Blinn-Phong, high glossiness", BlinnPhongOf(HighGlossiness));
  add("ward-high", "Ward, high glossiness", WardOf(HighGlossiness, 10.0));
  add("lafortune-high", "Lafortune, high glossiness", LafortuneOf(HighGlossiness, 10.0));
  return section;
}

GallerySection SkinSection()
{
  GallerySection section{ "Bone behind translucent skin",
    "After Fig. 9: skin covers the bone and hides a part of it. Highlights drawn out along the cheek bone, "
    "the temporal line and the edge of the missing piece of the frontal bone keep its form readable.",
    3, {} };
  PictureSettings settings = Cranium();
  settings.Camera = { 60.0, 4.0, 0.0, 2.0, {}, {}, {} };
  settings.Step = 0.45;
  settings.Ambient.Radius = 6.0;
  settings.Function.Opacity = { { -1024.0, 0.0 }, { -450.0, 0.0 }, { -300.0, 0.06 }, { -150.0, 0.12 },
    { 40.0, 0.05 }, { 140.0, 0.02 }, { 200.0, 0.15 }, { 260.0, 0.4 }, { 400.0, 0.9 }, { 3100.0, 1.0 } };
  section.Pictures = { Picture("skin-none", "Phase function alone", "cranium", settings, Model("none")),
    Picture("skin-blinn-phong", "Blinn-Phong", "cranium", settings, BlinnPhongOf(40.0)),
    Picture("skin-lafortune", "Lafortune", "cranium", settings, LafortuneOf(40.0, 10.0)) };
  return section;
}

GallerySection MarschnerLobbSection()
{
  GallerySection section{ "Marschner-Lobb signal",
    "After Fig. 7: with isotropic highlights the rings break off where they turn away from the light; "
    "moderate scaling of the anisotropy (10) closes them, strong scaling (60) draws them through. Ward's "
    "lobe is normalised: drawn out it is dimmer, and its strength is raised as stated.",
    5, {} };
  const auto add = [&](const std::string& name, const std::string& title, const OpticsSettings& optics,
                     double highlights = 1.0) {
    section.Pictures.push_back(
      Picture("marschner-lobb-" + name, title, "marschner-lobb", MarschnerLobb(), optics, highlights));
  };
  add("blinn-phong", "Blinn-Phong", BlinnPhongOf(HighGlossiness));
  add("ward-10", "Ward, gamma 10", WardOf(HighGlossiness, 10.0), 6.0);
  add("lafortune-10", "Lafortune, gamma 10", LafortuneOf(HighGlossiness, 10.0));
  add("ward-60", "Ward, gamma 60", WardOf(HighGlossiness, 60.0), 6.0);
  add("lafortune-60", "Lafortune, gamma 60", LafortuneOf(HighGlossiness, 60.0));
  return section;
}

GallerySection PrimitiveSection()
{
  GallerySection section{ "Sphere, ellipsoid, cylinder",
    "After Fig. 2: an isotropic form keeps a round highlight, a prolate one stretches it, a linear one "
    "draws it out into a line. Blinn-Phong for comparison.",
    3, {} };
  const std::pair<const char*, OpticsSettings> models[] = { { "Blinn-Phong", BlinnPhongOf(40.0) },
    { "Ward", WardOf(40.0, 6.0) }, { "Lafortune", LafortuneOf(40.0, 6.0) } };
  for (const auto& [name, optics] : models)
  {
    for (const std::string field : { "sphere", "ellipsoid", "cylinder" })
    {
      PictureSettings settings = Primitive();
      if (field == "cylinder") // off its flat ends
      {
        settings.Ambient.Radius = 12.0;
        settings.Ambient.FilterStandardDeviation = 1.5;
      }
      section.Pictures.push_back(
        Picture(field + "-" + optics.Model, field + ", " + name, field, settings, optics));
    }
  }
  return section;
}

GallerySection PackedSection()
{
  GallerySection section{ "Packed ellipsoids: the scale of the anisotropy",
    "After Fig. 5: principal curvatures and a small radius follow each ellipsoid; a large radius follows "
    "the columns that they form, also in the outermost, whose members are spheres. Ratios of curvatures are "
    "large: "
    "these highlights are dim. Below, from so far away "
    "that the picture has 48 pixels a side (enlarged).",
    3, {} };
  for (const bool isNear : { true, false })
  {
    for (const std::string estimate : { "curvature", "small", "large" })
    {
      PictureSettings settings = PackedEllipsoids();
      OpticsSettings ward = Model("ward", 0.2, 6.0);
      ward.FrameSource = estimate == "curvature" ? "curvature" : "covariance";
      if (estimate == "large")
      {
        settings.Ambient.Radius = 40.0;
        settings.Ambient.Samples = 800;
        settings.Ambient.FilterStandardDeviation = 3.0;
      }
      const std::string title = estimate == "curvature" ? "Principal curvatures"
        : estimate == "small"                           ? "Small radius"
                                                        : "Large radius";
      settings.Camera.Zoom = isNear ? 2.2 : 1.0;
      if (!isNear)
      {
        settings.Size = { FarSize, FarSize };
      }
      const std::string place = isNear ? "near" : "far";
      section.Pictures.push_back(
        Picture("packed-" + estimate + "-" + place, title + ", " + place, "packed", settings, ward));
    }
  }
  return section;
}

struct Study
{
  const char* Name;
  const char* Title;
  AmbientSettings Ambient;
  double Gamma;
};

GallerySection StudySection()
{
  GallerySection section{ "Parameters of the estimate",
    "After Fig. 6, on an ellipsoid that fills the volume. The reference stretches the highlight strongly "
    "(gamma 60) or moderately (10). A radius too small sees no anisotropy, and a large gamma then shows its "
    "errors; an interval too large takes in what is not the surface; too few samples are noise, and a "
    "filter wide enough to hide it blurs the frames, too.",
    4, {} };
  AmbientSettings reference = Primitive().Ambient;
  AmbientSettings smallRadius = reference, largeInterval = reference, fewSamples = reference;
  smallRadius.Radius = 2.0;
  smallRadius.FilterStandardDeviation = 0.0;
  smallRadius.ResolutionFactor = 1.0;
  largeInterval.Tolerance = 0.5;
  fewSamples.Samples = 10;
  fewSamples.Pattern = "per-voxel";
  fewSamples.FilterStandardDeviation = 0.0;
  fewSamples.ResolutionFactor = 1.0;
  AmbientSettings filtered = fewSamples;
  filtered.FilterStandardDeviation = 5.0;
  const Study studies[] = { { "reference-60", "Reference, gamma 60", reference, 60.0 },
    { "reference-10", "Reference, gamma 10", reference, 10.0 },
    { "radius-60", "Too small a radius, gamma 60", smallRadius, 60.0 },
    { "radius-10", "Too small a radius, gamma 10", smallRadius, 10.0 },
    { "interval-60", "Too large an interval, gamma 60", largeInterval, 60.0 },
    { "interval-10", "Too large an interval, gamma 10", largeInterval, 10.0 },
    { "samples-60", "Too few samples, gamma 60", fewSamples, 60.0 },
    { "filtered-60", "Too few samples, filtered, gamma 60", filtered, 60.0 } };
  for (const Study& study : studies)
  {
    PictureSettings settings = Primitive();
    settings.Size = { StudySize, StudySize };
    settings.Ambient = study.Ambient;
    const std::string name = std::string("study-") + study.Name;
    section.Pictures.push_back(Picture(name + "-ward", std::string("Ward. ") + study.Title, "ellipsoid",
      settings, WardOf(40.0, study.Gamma), study.Gamma > 10.0 ? 4.0 : 1.0));
    section.Pictures.push_back(Picture(name + "-lafortune", std::string("Lafortune. ") + study.Title,
      "ellipsoid", settings, LafortuneOf(40.0, study.Gamma)));
  }
  return section;
}

GallerySection TubesSection()
{
  GallerySection section{ "Vortex-like tubes",
    "After Fig. 1: the phase function alone shows outlines. Isotropic highlights are sparse and sit where a "
    "tube happens to bend towards the light; anisotropic ones run along the tubes.",
    4, {} };
  section.Pictures = { Picture("tubes-none", "Phase function alone", "tubes", Tubes(), Model("none")),
    Picture("tubes-blinn-phong", "Blinn-Phong", "tubes", Tubes(), BlinnPhongOf(HighGlossiness)),
    Picture("tubes-ward", "Ward", "tubes", Tubes(), WardOf(HighGlossiness, 10.0)),
    Picture("tubes-lafortune", "Lafortune", "tubes", Tubes(), LafortuneOf(HighGlossiness, 10.0)) };
  return section;
}
}

std::vector<GallerySection> GalleryList(bool withCranium)
{
  std::vector<GallerySection> sections;
  if (withCranium)
  {
    sections = { CraniumSection(), SkinSection() };
  }
  for (const auto& section :
    { MarschnerLobbSection(), PrimitiveSection(), PackedSection(), StudySection(), TubesSection() })
  {
    sections.push_back(section);
  }
  for (const auto& more : { IntegrationSections(withCranium), LightingSections(withCranium),
         OcclusionSections(withCranium), LineSections() })
  {
    sections.insert(sections.end(), more.begin(), more.end());
  }
  return sections;
}
