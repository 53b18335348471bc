// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryLighting.h"

#include "GalleryScenes.h"

#include <sstream>

namespace
{
struct Boundary
{
  std::array<double, 2> A, B;
  double Softness;
  std::array<double, 3> Coefficients; // ambient, diffuse, specular
};

const std::array<double, 2> Everything = { -1.0e9, 1.0e9 };
const std::array<double, 2> Air = { -1100.0, -650.0 }, Tissue = { -250.0, 160.0 }, Bone = { 380.0, 3100.0 };

std::string LightingOf(const std::vector<Boundary>& boundaries)
{
  nlohmann::json list = nlohmann::json::array();
  for (const Boundary& boundary : boundaries)
  {
    list.push_back({ { "RangeA", boundary.A }, { "RangeB", boundary.B }, { "Softness", boundary.Softness },
      { "Ambient", boundary.Coefficients[0] }, { "Diffuse", boundary.Coefficients[1] },
      { "Specular", boundary.Coefficients[2] } });
  }
  return nlohmann::json{ { "Boundaries", list } }.dump();
}

// Everything but air of one opacity: what is seen through it tells how thick it is.
PictureSettings UniformCranium(double opacity)
{
  PictureSettings settings = Cranium();
  settings.Step = 0.5;
  settings.Lights = { { -35.0, 25.0, 1.0 } };
  settings.Function.Opacity = { { -1024.0, 0.0 }, { -500.0, 0.0 }, { -350.0, opacity }, { 3100.0, opacity } };
  settings.Function.Color = { { -350.0, 0.8, 0.5, 0.38 }, { 120.0, 0.75, 0.42, 0.3 },
    { 300.0, 0.93, 0.86, 0.72 }, { 3100.0, 1.0, 0.97, 0.9 } };
  settings.Lighting.StepLength = 1.5;
  return settings;
}

GallerySection UniformOpacitySection()
{
  GallerySection section{ "Light where materials meet: cranium, CT, of one opacity",
    "After Fig. 1 of [Lum2004]: of one opacity everywhere, without light, the head is a fog whose density "
    "shows thickness. Light everywhere brings out the noise of the tissue as much as surfaces. Opacity "
    "raised at the boundaries shows surfaces, but hides what is behind them. A lighting transfer function "
    "keeps the opacity and lights the boundaries of air and skin, weakly, and of tissue and bone.",
    4, {} };
  PictureSettings unlit = UniformCranium(0.012);
  unlit.Function.Shade = false;
  section.Pictures.push_back({ "lighting-none", "No light", "cranium", unlit });

  PictureSettings everywhere = UniformCranium(0.012);
  everywhere.Lighting.Function = LightingOf({ { Everything, Everything, 0.0, { 0.1, 0.7, 0.5 } } });
  everywhere.Lighting.Scale = 1.5;
  section.Pictures.push_back({ "lighting-uniform", "Light everywhere", "cranium", everywhere });

  PictureSettings opaque = everywhere;
  opaque.Step = 0.25; // short enough for steep opacity: longer ones leave rings
  opaque.Function.Opacity = { { -1024.0, 0.0 }, { -600.0, 0.0 }, { -400.0, 0.05 }, { -250.0, 0.002 },
    { 120.0, 0.002 }, { 380.0, 0.3 }, { 550.0, 0.3 }, { 750.0, 0.02 }, { 3100.0, 0.02 } };
  section.Pictures.push_back({ "lighting-opacity", "Opacity at the boundaries", "cranium", opaque });

  PictureSettings chosen = UniformCranium(0.012);
  chosen.Lighting.Function = LightingOf({ { Everything, Everything, 0.0, { 0.08, 0.0, 0.0 } },
    { Air, Tissue, 150.0, { 0.0, 0.12, 0.06 } }, { Tissue, Bone, 120.0, { 0.0, 0.9, 0.5 } } });
  chosen.Lighting.Scale = 5.0;
  section.Pictures.push_back({ "lighting-chosen", "Lighting transfer function", "cranium", chosen });
  return section;
}

GallerySection SidesSection()
{
  GallerySection section{ "The side of the light",
    "One light from the left, half behind the head. Two-sided light falls on both sides of the bone alike, "
    "and the form is ambiguous; "
    "hybrid normals, which turn to the side of the lower opacity, leave the right half in the shade.",
    2, {} };
  PictureSettings settings = UniformCranium(0.02);
  settings.Function.Opacity = { { -1024.0, 0.0 }, { 150.0, 0.0 }, { 350.0, 0.4 }, { 3100.0, 0.4 } };
  settings.Lights = { { -105.0, 20.0, 1.0 } };
  settings.Lighting.Function = LightingOf(
    { { Everything, Everything, 0.0, { 0.06, 0.0, 0.0 } }, { Tissue, Bone, 200.0, { 0.0, 0.9, 0.4 } } });
  section.Pictures.push_back({ "sides-both", "Two-sided", "cranium", settings });
  settings.Lighting.HybridNormals = true;
  section.Pictures.push_back({ "sides-hybrid", "Hybrid normals", "cranium", settings });
  return section;
}

GallerySection FallingSection()
{
  GallerySection section{ "Bone of falling opacity",
    "The same boundary at an opacity of 0.1, 0.02 and 0.004 a millimetre. Rising light keeps it visible: "
    "colour may exceed opacity, and what is behind the front shows, too.",
    3, {} };
  const std::pair<const char*, double> steps[] = { { "0.1", 4.0 }, { "0.02", 5.0 }, { "0.004", 12.0 } };
  for (const auto& [opacity, scale] : steps)
  {
    PictureSettings settings = UniformCranium(std::stod(opacity));
    settings.Lighting.Function = LightingOf({ { Tissue, Bone, 120.0, { 0.1, 0.7, 0.4 } } });
    settings.Lighting.Scale = scale;
    std::ostringstream title;
    title << "Opacity " << opacity << ", light scale " << scale;
    section.Pictures.push_back({ std::string("falling-") + opacity, title.str(), "cranium", settings });
  }
  return section;
}

PictureSettings PlantPicture()
{
  PictureSettings settings = MarschnerLobb();
  settings.Camera = { 20.0, 12.0, 0.0, 1.5, {}, {}, {} };
  settings.Lights = { { -25.0, 25.0, 1.0 } };
  settings.Step = 0.4;
  settings.Function.Opacity = { { 0.0, 0.0 }, { 0.18, 0.0 }, { 0.28, 0.7 }, { 10.0, 0.7 } };
  settings.Function.Color = { { 0.0, 0.25, 0.6, 0.16 }, { 0.62, 0.25, 0.6, 0.16 }, { 0.68, 0.6, 0.38, 0.2 },
    { 1.0, 0.6, 0.38, 0.2 } };
  settings.Function.Ambient = 0.25;
  settings.Function.Diffuse = 0.75;
  settings.Function.Specular = 0.15;
  settings.Lighting.StepLength = 3.0;
  return settings;
}

GallerySection PlantSection()
{
  GallerySection section{ "Branches and leaves: classification by three scalars",
    "After Fig. 11 of [Lum2004]: branches are denser than leaves, leaves than air. The soft edges of "
    "branches "
    "have the scalars of leaves, and a transfer function covers them in green. By the scalars on both sides "
    "as well, an edge that leads uphill to "
    "a branch belongs to the branch.",
    2, {} };
  PictureSettings settings = PlantPicture();
  section.Pictures.push_back({ "plant-one", "Transfer function", "plant", settings });
  const std::array<double, 2> edge = { 0.1, 0.75 }, uphill = { 0.6, 2.0 };
  settings.Lighting.Rules = nlohmann::json{
    { "Rules", { { { "S", edge }, { "S1", uphill }, { "Color", { 0.6, 0.38, 0.2 } }, { "Opacity", 0.7 } } } }
  }.dump();
  section.Pictures.push_back({ "plant-three", "By three scalars", "plant", settings });
  return section;
}
}

std::vector<GallerySection> LightingSections(bool withCranium)
{
  std::vector<GallerySection> sections;
  if (withCranium)
  {
    sections = { UniformOpacitySection(), SidesSection(), FallingSection() };
  }
  sections.push_back(PlantSection());
  return sections;
}
