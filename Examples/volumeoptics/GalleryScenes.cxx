// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryScenes.h"

#include <array>
#include <cmath>

namespace
{
constexpr int PictureSize = 416;

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
}

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

OpticsSettings Model(const std::string& model, double glossiness, double anisotropy)
{
  OpticsSettings optics;
  optics.Model = model;
  optics.Glossiness = glossiness;
  optics.Anisotropy = anisotropy;
  return optics;
}

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
