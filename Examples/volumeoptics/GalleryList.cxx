// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryList.h"

#include <vtkMath.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace
{
constexpr int PictureSize = 416;
constexpr int StudySize = 288;
constexpr int FarSize = 48;
constexpr int ScorePictureSize = 256;

OpticsSettings Model(const std::string& model, double glossiness = -1.0, double anisotropy = -1.0)
{
  OpticsSettings optics;
  optics.Model = model;
  optics.Glossiness = glossiness;
  optics.Anisotropy = anisotropy;
  return optics;
}

// An opaque surface at value, as steep as the fields' resolution allows, on a dark base that lets
// highlights carry the form.
TransferFunction Surface(double value, double softness, std::array<double, 3> color)
{
  TransferFunction function;
  function.Opacity = { { value - softness, 0.0 }, { value + softness, 0.9 }, { 10.0, 0.9 } };
  function.Color = { { value, color[0], color[1], color[2] } };
  function.Ambient = 0.05;
  function.Diffuse = 0.35;
  function.Specular = 1.0;
  return function;
}

// The same with a thin dark seam around it: the phase function has no cosine, so where one form passes
// before another only a seam parts them.
TransferFunction SurfaceWithSeam(double value, double softness, std::array<double, 3> color)
{
  TransferFunction function = Surface(value, softness, color);
  const double seam = 0.06;
  function.Opacity = { { 0.1, 0.0 }, { 0.12, seam }, { value - softness, seam }, { value + softness, 0.9 },
    { 10.0, 0.9 } };
  function.Color = { { value - softness, 0.01, 0.015, 0.02 },
    { value, 0.6 * color[0], 0.6 * color[1], 0.6 * color[2] },
    { value + softness, color[0], color[1], color[2] } };
  return function;
}

PictureSettings Base(const TransferFunction& function, double azimuth, double elevation, double zoom)
{
  PictureSettings settings;
  settings.Function = function;
  settings.Camera.Azimuth = azimuth;
  settings.Camera.Elevation = elevation;
  settings.Camera.Zoom = zoom;
  settings.Lights = { { -20.0, 25.0, 1.0 } };
  settings.Size = { PictureSize, PictureSize };
  settings.Background = { 0.07, 0.08, 0.1 };
  settings.Ambient.FilterStandardDeviation = 1.5;
  settings.Ambient.Precision = 16;
  return settings;
}

// ---- scenes shared by the pictures and the scores

// All voxels of a ball, on a coarser grid: frames of forms this large vary slowly.
void TakeWholeBall(AmbientSettings& ambient, double radius, double resolutionFactor)
{
  ambient.Radius = radius;
  ambient.Pattern = "exhaustive";
  ambient.ResolutionFactor = resolutionFactor;
}

PictureSettings Cranium()
{
  PictureSettings settings = Base(Preset("cranium"), -50.0, 3.0, 1.65);
  settings.Lights = { { -14.0, 18.0, 1.0 } };
  settings.Step = 0.6;
  settings.Ambient.Radius = 8.0;
  settings.Ambient.Samples = 300;
  settings.Ambient.FilterStandardDeviation = 2.0;
  return settings;
}

PictureSettings MarschnerLobb()
{
  PictureSettings settings = Base(Surface(0.5, 0.03, { 0.62, 0.48, 0.3 }), 25.0, 50.0, 1.5);
  settings.Function.Specular = 3.0;
  settings.Lights = { { -8.0, 10.0, 1.0 } };
  settings.Step = 0.25;
  TakeWholeBall(settings.Ambient, 5.0, 1.0);
  return settings;
}

PictureSettings Primitive()
{
  PictureSettings settings = Base(Surface(0.5, 0.04, { 0.3, 0.45, 0.7 }), 0.0, 0.0, 1.55);
  settings.Function.Specular = 1.5;
  settings.Lights = { { -25.0, 14.0, 1.0 } };
  TakeWholeBall(settings.Ambient, 24.0, 0.5);
  settings.Ambient.FilterStandardDeviation = 3.0;
  return settings;
}

PictureSettings PackedEllipsoids()
{
  PictureSettings settings = Base(SurfaceWithSeam(0.45, 0.06, { 0.75, 0.55, 0.42 }), 0.0, 0.0, 1.5);
  settings.Lights = { { -20.0, 12.0, 1.0 } };
  settings.Ambient.Radius = 3.0;
  settings.Ambient.Samples = 300;
  return settings;
}

PictureSettings Tubes()
{
  PictureSettings settings = Base(SurfaceWithSeam(0.5, 0.06, { 0.3, 0.5, 0.75 }), 30.0, 15.0, 1.3);
  settings.Lights = { { -20.0, 22.0, 1.0 } };
  settings.Ambient.Radius = 6.0;
  settings.Ambient.Samples = 300;
  return settings;
}

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

// ---- one size of highlight for all models

OpticsSettings BlinnPhongOf(double exponent)
{
  return Model("blinn-phong", exponent);
}

// exp(-tan^2/kappa^2) has the half width of cos^n at kappa^2 = 2/n.
OpticsSettings WardOf(double exponent, double anisotropy)
{
  return Model("ward", std::sqrt(2.0 / exponent), anisotropy);
}

// R turns by twice the angle that N does: cos^(n/4) of twice the angle is as wide as cos^n.
OpticsSettings LafortuneOf(double exponent, double anisotropy)
{
  return Model("lafortune", exponent / 4.0, anisotropy);
}

constexpr double HighGlossiness = 80.0;
constexpr double LowGlossiness = 10.0;

// ---- sections

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
  return sections;
}

std::vector<std::string> ScoreRules()
{
  return { "equal-size", "gamma-40", "as-printed", "equal-peaks", "paper-weights", "saturated" };
}

// Blinn-Phong, Ward, Lafortune.
static std::vector<ScoreModel> ScoreModels(const std::string& rule, double exponent)
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
