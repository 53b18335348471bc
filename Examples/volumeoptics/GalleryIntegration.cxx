// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sections of the gallery on the integral in data space, after the figures of [Kraus2005].

#include "GalleryList.h"

#include <cmath>

namespace
{
constexpr int PictureSize = 416;

using Isosurfaces = std::vector<std::vector<double>>;

struct View
{
  double Azimuth, Elevation, Zoom;
};

// Pre-integrated, so that thin peaks are whole also in physical space; unlit, so that opacity is all that
// is seen.
PictureSettings Base(const View& view)
{
  PictureSettings settings;
  settings.Camera.Azimuth = view.Azimuth;
  settings.Camera.Elevation = view.Elevation;
  settings.Camera.Zoom = view.Zoom;
  settings.Size = { PictureSize, PictureSize };
  settings.Step = 1.0; // a voxel: surfaces are found between the samples
  settings.Function.Shade = false;
  settings.Function.Opacity = { { 0.0, 0.0 }, { 1.0, 0.0 } };
  settings.Function.Color = { { 0.0, 1.0, 1.0, 1.0 } };
  settings.Function.Integration.Classification = "pre-integrated";
  return settings;
}

// Peaks of the opacity function at the isosurfaces: what standard volume rendering has for them. How opaque
// they are is a matter of trial and error with unitDistance: it takes the gradients in.
void MakePeaks(TransferFunction& function, const Isosurfaces& surfaces, double unitDistance)
{
  const double halfWidth = 0.005;
  function.Opacity = { { 0.0, 0.0 } };
  function.Color.clear();
  function.UnitDistance = unitDistance;
  for (const std::vector<double>& surface : surfaces)
  {
    const double value = surface.front();
    function.Opacity.push_back({ value - halfWidth, 0.0 });
    function.Opacity.push_back({ value, surface.back() });
    function.Opacity.push_back({ value + halfWidth, 0.0 });
    for (const double end : { value - halfWidth, value + halfWidth })
    {
      function.Color.push_back({ end, surface[1], surface[2], surface[3] });
    }
  }
  function.Opacity.push_back({ 1.0, 0.0 });
}

GalleryPicture Standard(const std::string& name, const std::string& field, PictureSettings settings,
  const Isosurfaces& surfaces, double unitDistance, const std::string& caption)
{
  MakePeaks(settings.Function, surfaces, unitDistance);
  return { name + "-standard", "Standard: opacity per length", field, settings, caption };
}

GalleryPicture ScaleInvariant(const std::string& name, const std::string& field, PictureSettings settings,
  const Isosurfaces& surfaces, const std::string& silhouette, const std::string& caption)
{
  IntegrationSettings& integration = settings.Function.Integration;
  integration.Space = "data";
  integration.Isosurfaces = surfaces;
  integration.Silhouette = silhouette;
  const std::string title = silhouette == "off" ? "Scale-invariant" : "Scale-invariant, silhouettes";
  return { name + (silhouette == "off" ? "-data" : "-data-" + silhouette), title, field, settings, caption };
}

// On a dark background, which shines through less.
void Shade(PictureSettings& settings, double azimuth, double elevation)
{
  settings.Background = { 0.07, 0.08, 0.1 };
  settings.Function.Shade = true;
  settings.Function.Ambient = 0.15;
  settings.Function.Diffuse = 0.9;
  settings.Function.Specular = 0.5;
  settings.Function.SpecularPower = 40.0;
  settings.Lights = { { azimuth, elevation, 1.0, true } };
}

const Isosurfaces CoulombSurfaces = { { 0.26, 0.1, 0.3, 0.85, 0.25 }, { 0.46, 0.9, 0.15, 0.1, 0.45 } };
// Of brighter colours, for light.
const Isosurfaces LitSurfaces = { { 0.26, 0.45, 0.7, 1.0, 0.35 }, { 0.46, 1.0, 0.45, 0.25, 0.6 } };
const View CoulombView = { 0.0, 8.0, 1.75 };

GallerySection CoulombSection()
{
  const std::string field = "coulomb";
  GallerySection section{ "Three Coulomb potentials",
    "After Figs. 1 and 2 of [Kraus2005]: charges of strength 1, 1/2 and 1/4, isosurfaces at two potentials. "
    "Their isosurfaces are copies of each other in another size, but opacity per length makes the large one "
    "far more opaque, and the blue one where it is between the charges: the gradient is small there. Opacity "
    "per difference of the scalar is the same everywhere: 0.45 of red, 0.25 of blue, on each charge.",
    4, {}, false };
  const PictureSettings settings = Base(CoulombView);
  PictureSettings lit = settings;
  Shade(lit, -30.0, 35.0);
  section.Pictures = { Standard("coulomb", field, settings, CoulombSurfaces, 1.0,
                         "The lowest red surface is the most opaque, the smallest is hardly there."),
    ScaleInvariant("coulomb", field, settings, CoulombSurfaces, "off", "Three red surfaces of one opacity."),
    ScaleInvariant("coulomb", field, settings, CoulombSurfaces, "exact",
      "Opacity grows where a ray grazes a surface: outlines tell its form."),
    ScaleInvariant("coulomb-lit", field, lit, LitSurfaces, "exact", "The same with light.") };
  return section;
}

GallerySection OrbitalSection()
{
  const std::string field = "orbital";
  const Isosurfaces surfaces = { { 0.12, 0.85, 0.45, 0.1, 0.35 } };
  GallerySection section{ "Hydrogen orbital 3d_z2",
    "After Fig. 8c and d: the density at one isovalue, two lobes and a ring. The ring's largest value is "
    "little above the isovalue, so the gradient is small there, and opacity per length makes the ring more "
    "opaque than the lobes.",
    3, {}, false };
  PictureSettings settings = Base({ 0.0, 22.0, 1.5 });
  section.Pictures = { Standard("orbital", field, settings, surfaces, 0.8,
                         "The ring looks denser than the lobes; nothing in the data says so."),
    ScaleInvariant("orbital", field, settings, surfaces, "off", "Opacity 0.35 on all three parts."),
    ScaleInvariant("orbital", field, settings, surfaces, "exact", "The same with silhouettes.") };
  return section;
}

GallerySection RidgesSection()
{
  const std::string field = "marschner-lobb";
  const Isosurfaces surfaces = { { 0.5, 0.1, 0.45, 0.6, 0.25 } };
  GallerySection section{ "Marschner-Lobb signal at isovalue 0.5",
    "After Fig. 8a and b: on the tops of the ridges and the bottoms of the valleys the gradient is smallest. "
    "Opacity per length makes them opaque, which looks like a silhouette where there is none.",
    3, {}, false };
  PictureSettings settings = Base({ 0.0, 62.0, 1.35 });
  settings.Step = 0.5; // ridges are thin
  section.Pictures = { Standard("ridges", field, settings, surfaces, 0.35,
                         "Dark lines on tops and bottoms, mixed with silhouettes."),
    ScaleInvariant("ridges", field, settings, surfaces, "off", "Each layer of the surface has opacity 0.25."),
    ScaleInvariant("ridges", field, settings, surfaces, "exact",
      "Lines are silhouettes alone: where the surface turns away.") };
  return section;
}

GallerySection ConstantSection()
{
  GallerySection section{ "Constant transfer function, CT of the cranium",
    "After Fig. 3a: one colour and one opacity for all values. Per length that is a box of fog. Per "
    "difference of the scalar it shows where values change: skin, bone, teeth, the sinuses, without any "
    "transfer function.",
    3, {}, false };
  PictureSettings settings = Base({ -50.0, 3.0, 1.65 });
  settings.Background = { 0.07, 0.08, 0.1 };
  settings.Function.Opacity = { { -1024.0, 0.02 }, { 3100.0, 0.02 } };
  settings.Function.Color = { { 0.0, 0.9, 0.93, 1.0 } };
  PictureSettings data = settings;
  data.Function.Integration.Space = "data";
  data.Function.Integration.UnitInterval = 200.0;
  PictureSettings steep = data;
  steep.Function.Integration.Silhouette = "exact";
  section.Pictures = { { "constant-standard", "Standard: opacity per length", "cranium", settings,
                         "The box that holds the data." },
    { "constant-data", "Scale-invariant", "cranium", data, "What values change across." },
    { "constant-data-exact", "Scale-invariant, silhouettes", "cranium", steep,
      "Outlines of skin and bone stand out." } };
  return section;
}

// The data from 0.2 to 0.65 lets 1/50 of the light through, by surfaces or by the integral.
GallerySection LimitSection()
{
  GallerySection section{ "Isosurfaces, ever more of them",
    "After Fig. 3: N isosurfaces at equidistant values, each of an opacity that falls with N, become the "
    "volume rendering integral in data space, which is their limit.",
    4, {}, false };
  const double transparency = 0.02, first = 0.2, last = 0.65, edge = 1.0e-5;
  PictureSettings settings = Base({ 0.0, 8.0, 1.5 });
  settings.Function.Color = { { 0.2, 0.15, 0.25, 0.75 }, { 0.3, 0.1, 0.65, 0.6 }, { 0.45, 0.9, 0.75, 0.15 },
    { 0.6, 0.85, 0.15, 0.1 } };
  settings.Function.Integration.Space = "data";
  for (const int count : { 4, 16, 64 })
  {
    PictureSettings some = settings;
    for (int i = 0; i < count; ++i)
    {
      some.Function.Integration.Isosurfaces.push_back(
        { first + (i + 0.5) / count * (last - first), 1.0 - std::pow(transparency, 1.0 / count) });
    }
    const std::string number = std::to_string(count);
    section.Pictures.push_back({ "limit-" + number, number + " isosurfaces", "coulomb", some,
      count == 4      ? "Shells with steps between them."
        : count == 16 ? "The steps get finer."
                      : "The steps are hardly seen." });
  }
  const double opacity = 1.0 - transparency;
  settings.Function.Opacity = { { 0.0, 0.0 }, { first - edge, 0.0 }, { first, opacity }, { last, opacity },
    { last + edge, 0.0 }, { 1.0, 0.0 } };
  settings.Function.Integration.UnitInterval = last - first;
  section.Pictures.push_back({ "limit-integral", "The integral", "coulomb", settings, "The limit." });
  return section;
}

GallerySection LightSection()
{
  GallerySection section{ "Light from behind",
    "After Fig. 6: translucent surfaces with the light before and behind them. Without transmission the side "
    "towards the viewer stays dark. Diffuse transmission lights the surface as far as it is translucent; "
    "specular transmission shows where the light is.",
    4, {}, false };
  PictureSettings settings = Base(CoulombView);
  Shade(settings, -25.0, 30.0);
  IntegrationSettings& integration = settings.Function.Integration;
  integration.Space = "data";
  integration.Isosurfaces = LitSurfaces;
  integration.Silhouette = "exact";
  section.Pictures.push_back(
    { "light-front", "Light from the front", "coulomb", settings, "Reflection alone, as usual." });
  Shade(settings, 170.0, 12.0);
  settings.Lights[0].Intensity = 1.5;
  section.Pictures.push_back({ "light-off", "From behind, no transmission", "coulomb", settings,
    "The near side is dark; the far side shines through it." });
  integration.TransmittedLight = "diffuse";
  section.Pictures.push_back({ "light-diffuse", "From behind, diffuse transmission", "coulomb", settings,
    "Surfaces glow with their own colour." });
  integration.TransmittedLight = "diffuse-and-specular";
  section.Pictures.push_back({ "light-specular", "From behind, diffuse and specular", "coulomb", settings,
    "A bright spot where the light shines through." });
  return section;
}

GallerySection SilhouetteSection()
{
  GallerySection section{ "Silhouettes",
    "After Fig. 5: a thin layer is longer along a ray that grazes it. Exact takes this length into the "
    "exponent; clamped divides the opacity by the cosine, which is simpler and too opaque near the outline.",
    3, {}, false };
  const Isosurfaces surfaces = { { 0.26, 0.1, 0.3, 0.85, 0.45 }, { 0.46, 0.9, 0.15, 0.1, 0.75 } };
  const PictureSettings settings = Base(CoulombView);
  const auto add = [&](const char* silhouette, const char* title, const char* caption) {
    GalleryPicture picture = ScaleInvariant("silhouette", "coulomb", settings, surfaces, silhouette, caption);
    picture.Title = title;
    section.Pictures.push_back(picture);
  };
  add("off", "Off", "Flat: nothing tells a ball from a disk.");
  add("exact", "Exact", "Opacity rises smoothly towards the outline.");
  add("clamped", "Clamped", "A broader rim that reaches opacity 1 before the outline.");
  return section;
}

GallerySection TetrahedraSection()
{
  GallerySection section{ "148,955 tetrahedra",
    "After Fig. 8e and f: a field like that of the bucky ball on 32^3 points, cut into tetrahedra and drawn "
    "by "
    "projection. In data space a table of two dimensions holds all that a cell can show.",
    3, {}, false };
  PictureSettings settings = Base({ 20.0, 25.0, 2.6 });
  settings.Function.Color = { { 0.0, 0.2, 0.4, 0.8 }, { 0.4, 0.2, 0.6, 0.75 }, { 0.7, 0.9, 0.6, 0.2 },
    { 1.0, 0.85, 0.2, 0.1 } };
  settings.Function.Opacity = { { 0.0, 0.0 }, { 0.08, 0.0 }, { 0.1, 0.35 }, { 1.0, 0.35 } };
  settings.Function.UnitDistance = 2.0;
  PictureSettings data = settings;
  data.Function.Integration.Space = "data";
  data.Function.Integration.UnitInterval = 0.4;
  PictureSettings outlined = data;
  outlined.Function.Integration.Silhouette = "exact";
  section.Pictures = { { "tetrahedra-standard", "VTK's projected tetrahedra", "bucky-tetrahedra", settings,
                         "Opacity per length: a fog around the atoms." },
    { "tetrahedra-data", "Scale-invariant", "bucky-tetrahedra", data,
      "Opacity per difference of the field." },
    { "tetrahedra-data-exact", "Scale-invariant, silhouettes", "bucky-tetrahedra", outlined,
      "Atoms and bonds get outlines." } };
  return section;
}
}

std::vector<GallerySection> IntegrationSections(bool withCranium)
{
  std::vector<GallerySection> sections = { CoulombSection(), OrbitalSection(), RidgesSection() };
  if (withCranium)
  {
    sections.push_back(ConstantSection());
  }
  for (const auto& section : { LimitSection(), LightSection(), SilhouetteSection(), TetrahedraSection() })
  {
    sections.push_back(section);
  }
  return sections;
}
