// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryList.h"

namespace
{
constexpr int PictureSize = 480;
constexpr int ScorePictureSize = 320;

OpticsSettings Model(const std::string& model, double glossiness = -1.0, double anisotropy = -1.0)
{
  OpticsSettings optics;
  optics.Model = model;
  optics.Glossiness = glossiness;
  optics.Anisotropy = anisotropy;
  return optics;
}

// An opaque surface at value, as steep as the fields' resolution allows.
TransferFunction Surface(double value, double softness, std::array<double, 3> color)
{
  TransferFunction function;
  function.Opacity = { { value - softness, 0.0 }, { value + softness, 0.9 }, { 10.0, 0.9 } };
  function.Color = { { value, color[0], color[1], color[2] } };
  function.Ambient = 0.1;
  function.Diffuse = 0.5;
  function.Specular = 0.6;
  return function;
}

PictureSettings Base(const TransferFunction& function, double azimuth, double elevation, double zoom)
{
  PictureSettings settings;
  settings.Function = function;
  settings.Camera.Azimuth = azimuth;
  settings.Camera.Elevation = elevation;
  settings.Camera.Zoom = zoom;
  settings.Light = { -20.0, 25.0, 1.0 };
  settings.Size = { PictureSize, PictureSize };
  settings.Background = { 0.07, 0.08, 0.1 };
  settings.Ambient.FilterStandardDeviation = 1.0;
  settings.Ambient.Precision = 16;
  settings.Ambient.Pattern = "exhaustive";
  return settings;
}

// ---- scenes shared by the pictures and the scores

// Balls too large for all their voxels: many points, the same for all voxels, are as smooth.
void SampleLargeBall(AmbientSettings& ambient, double radius)
{
  ambient.Radius = radius;
  ambient.Pattern = "shared";
  ambient.Samples = 1000;
}

PictureSettings Cranium()
{
  PictureSettings settings = Base(Preset("cranium"), -40.0, 6.0, 1.55);
  settings.Step = 0.8;
  settings.Ambient.Radius = 8.0;
  settings.Ambient.FilterStandardDeviation = 2.0;
  return settings;
}

PictureSettings MarschnerLobb()
{
  PictureSettings settings = Base(Surface(0.5, 0.02, { 0.75, 0.66, 0.5 }), 25.0, 50.0, 1.1);
  settings.Ambient.Radius = 10.0;
  return settings;
}

PictureSettings Primitive()
{
  PictureSettings settings = Base(Surface(0.5, 0.04, { 0.35, 0.5, 0.72 }), 0.0, 0.0, 1.6);
  SampleLargeBall(settings.Ambient, 16.0);
  settings.Ambient.Tolerance = 0.05;
  return settings;
}

PictureSettings PackedEllipsoids()
{
  PictureSettings settings = Base(Surface(0.14, 0.05, { 0.62, 0.5, 0.42 }), 0.0, 0.0, 1.6);
  settings.Ambient.Radius = 3.0;
  return settings;
}

PictureSettings Tubes()
{
  PictureSettings settings = Base(Surface(0.5, 0.08, { 0.45, 0.6, 0.72 }), 30.0, 15.0, 1.3);
  settings.Ambient.Radius = 6.0;
  return settings;
}

GalleryPicture Picture(const std::string& name, const std::string& title, const std::string& field,
  PictureSettings settings, const OpticsSettings& optics)
{
  settings.Optics = optics;
  return { name, title, field, settings };
}

// ---- sections

GallerySection CraniumSection()
{
  GallerySection section{ "Cranium, CT",
    "Bone opaque, skin translucent; a head of the Debian package invesalius-examples. Stock VTK, the "
    "phase function alone, and highlights of three models at low and high glossiness.",
    4, {} };
  const auto add = [&](const std::string& name, const std::string& title, const OpticsSettings& optics) {
    section.Pictures.push_back(Picture("cranium-" + name, title, "cranium", Cranium(), optics));
  };
  add("vtk", "Stock VTK shading", Model("vtk"));
  add("blinn-phong-low", "Blinn-Phong, low glossiness", Model("blinn-phong", 10.0));
  add("ward-low", "Ward, low glossiness", Model("ward", 0.4, 6.0));
  add("lafortune-low", "Lafortune, low glossiness", Model("lafortune", 8.0, 10.0));
  add("none", "Phase function alone", Model("none"));
  add("blinn-phong-high", "Blinn-Phong, high glossiness", Model("blinn-phong", 40.0));
  add("ward-high", "Ward, high glossiness", Model("ward", 0.2, 10.0));
  add("lafortune-high", "Lafortune, high glossiness", Model("lafortune", 20.0, 10.0));
  return section;
}

GallerySection SkinSection()
{
  GallerySection section{ "Bone behind translucent skin",
    "After Fig. 9: where tissue hides the bone partly, drawn-out highlights keep its shape readable.", 2,
    {} };
  PictureSettings settings = Cranium();
  settings.Camera = { 55.0, 4.0, 0.0, 2.2, {}, {}, {} };
  settings.Function.Opacity = { { -1024.0, 0.0 }, { -400.0, 0.0 }, { -250.0, 0.08 }, { -100.0, 0.12 },
    { 40.0, 0.04 }, { 150.0, 0.02 }, { 220.0, 0.3 }, { 400.0, 0.9 }, { 3100.0, 1.0 } };
  section.Pictures = { Picture(
                         "skin-blinn-phong", "Blinn-Phong", "cranium", settings, Model("blinn-phong", 10.0)),
    Picture("skin-ward", "Ward", "cranium", settings, Model("ward", 0.2, 40.0)) };
  return section;
}

GallerySection MarschnerLobbSection()
{
  GallerySection section{ "Marschner-Lobb signal",
    "After Fig. 7: moderate and strong scaling of the anisotropy against isotropic highlights.", 5, {} };
  const auto add = [&](const std::string& name, const std::string& title, const OpticsSettings& optics) {
    section.Pictures.push_back(
      Picture("marschner-lobb-" + name, title, "marschner-lobb", MarschnerLobb(), optics));
  };
  add("blinn-phong", "Blinn-Phong", Model("blinn-phong", 30.0));
  add("ward-10", "Ward, gamma 10", Model("ward", 0.2, 10.0));
  add("lafortune-10", "Lafortune, gamma 10", Model("lafortune", 30.0, 10.0));
  add("ward-60", "Ward, gamma 60", Model("ward", 0.2, 60.0));
  add("lafortune-60", "Lafortune, gamma 60", Model("lafortune", 30.0, 60.0));
  return section;
}

GallerySection PrimitiveSection()
{
  GallerySection section{ "Sphere, ellipsoid, cylinder",
    "After Fig. 2: an isotropic shape keeps a round highlight, a prolate one stretches it, a linear one "
    "draws it out into a line.",
    3, {} };
  for (const std::string field : { "sphere", "ellipsoid", "cylinder" })
  {
    section.Pictures.push_back(
      Picture(field + "-ward", field + ", Ward", field, Primitive(), Model("ward", 0.2, 10.0)));
  }
  for (const std::string field : { "sphere", "ellipsoid", "cylinder" })
  {
    section.Pictures.push_back(Picture(
      field + "-lafortune", field + ", Lafortune", field, Primitive(), Model("lafortune", 30.0, 10.0)));
  }
  return section;
}

GallerySection PackedSection()
{
  GallerySection section{ "Packed ellipsoids: the scale of the anisotropy",
    "After Fig. 5: principal curvatures and a small radius follow each ellipsoid, a large radius follows "
    "the arrangement. Near, and from far away, where local estimates alias.",
    2, {} };
  for (const std::string estimate : { "curvature", "small", "large" })
  {
    PictureSettings settings = PackedEllipsoids();
    OpticsSettings ward = Model("ward", 0.2, 10.0);
    ward.FrameSource = estimate == "curvature" ? "curvature" : "covariance";
    if (estimate == "large")
    {
      SampleLargeBall(settings.Ambient, 30.0);
    }
    const std::string title = estimate == "curvature" ? "Principal curvatures"
      : estimate == "small"                           ? "Small radius"
                                                      : "Large radius";
    section.Pictures.push_back(
      Picture("packed-" + estimate + "-near", title + ", near", "packed", settings, ward));
    settings.Camera.Zoom *= 0.3;
    section.Pictures.push_back(
      Picture("packed-" + estimate + "-far", title + ", far", "packed", settings, ward));
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
    "After Fig. 6, on an ellipsoid that fills the volume: what a radius too small, an interval too large and "
    "too few samples do, with strong (60) and moderate (10) scaling.",
    4, {} };
  const AmbientSettings reference = { 24.0, 1000, 0.02, 1.0, 0.0, "shared", 16 };
  AmbientSettings smallRadius = reference, largeInterval = reference, fewSamples = reference;
  smallRadius.Radius = 1.0;
  largeInterval.Tolerance = 0.5;
  fewSamples.Samples = 10;
  fewSamples.Pattern = "per-voxel";
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
    settings.Size = { PictureSize * 3 / 4, PictureSize * 3 / 4 };
    settings.Ambient = study.Ambient;
    const std::string name = std::string("study-") + study.Name;
    section.Pictures.push_back(Picture(name + "-ward", std::string("Ward. ") + study.Title, "ellipsoid",
      settings, Model("ward", 0.2, study.Gamma)));
    section.Pictures.push_back(Picture(name + "-lafortune", std::string("Lafortune. ") + study.Title,
      "ellipsoid", settings, Model("lafortune", 30.0, study.Gamma)));
  }
  return section;
}

GallerySection TubesSection()
{
  GallerySection section{ "Vortex-like tubes",
    "After Fig. 1: the phase function alone, isotropic highlights, and highlights along the tubes.", 3, {} };
  section.Pictures = { Picture("tubes-none", "Phase function alone", "tubes", Tubes(), Model("none")),
    Picture("tubes-blinn-phong", "Blinn-Phong", "tubes", Tubes(), Model("blinn-phong", 30.0)),
    Picture("tubes-lafortune", "Lafortune", "tubes", Tubes(), Model("lafortune", 30.0, 20.0)) };
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

std::vector<ScoreScene> ScoreScenes(bool withCranium)
{
  const std::vector<OpticsSettings> high = { Model("blinn-phong", 40.0), Model("ward", 0.2, 10.0),
    Model("lafortune", 20.0, 10.0) };
  const std::vector<OpticsSettings> low = { Model("blinn-phong", 10.0), Model("ward", 0.4, 6.0),
    Model("lafortune", 8.0, 10.0) };
  const std::vector<OpticsSettings> strong = { Model("blinn-phong", 30.0), Model("ward", 0.2, 60.0),
    Model("lafortune", 30.0, 60.0) };
  std::vector<ScoreScene> scenes;
  if (withCranium)
  {
    scenes = { { "Cranium, high glossiness", "cranium", Cranium(), high, {} },
      { "Cranium, low glossiness", "cranium", Cranium(), low, {} } };
  }
  const std::vector<ScoreScene> fields = { { "Marschner-Lobb", "marschner-lobb", MarschnerLobb(), strong,
                                             {} },
    { "Ellipsoid", "ellipsoid", Primitive(), strong, {} },
    { "Packed ellipsoids", "packed", PackedEllipsoids(), strong, {} },
    { "Vortex tubes", "tubes", Tubes(), strong, {} } };
  scenes.insert(scenes.end(), fields.begin(), fields.end());
  for (ScoreScene& scene : scenes)
  {
    scene.Settings.Size = { ScorePictureSize, ScorePictureSize };
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
