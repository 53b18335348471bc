// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Isosurfaces, silhouettes and transmitted light of the reference renderer.

#include "DataSpaceScenes.h"

#include <string>

using namespace reference;
using namespace scenes;

namespace
{
// An isosurface of opacity a has it on every ray that crosses it once: slopes over six decades, long and
// short steps, three scales of the world.
void TestUniformOpacity(Check& check)
{
  for (double opacity : { 0.0, 0.01, 0.4, 1.0 })
  {
    Scene scene = MakeDataScene(std::make_shared<SlopesField>(3.0));
    scene.isosurfaces.push_back({ 0.5, Vector(0.2, 0.5, 1.0), opacity });
    for (double scale : { 1e-6, 1.0, 1e6 })
    {
      for (double step : { 1.0 / 128.0, 1.0 / 32.0, 1.0 / 8.0 })
      {
        scene.step = step;
        const Scene scaled = Scaled(scene, scale);
        for (double x : { -1.0, -0.5, 0.01, 0.99 })
        {
          const glm::dvec4 pixel = PixelAt(scaled, x, 0.3);
          check.Near("an isosurface's opacity", pixel.a, opacity, Rounding);
          check.Near("its colour", pixel.g, 0.5 * opacity, Rounding);
        }
      }
    }
  }
}

// Two surfaces in one segment come in the ray's order, and a volume between them in its place.
void TestOrder(Check& check)
{
  Scene scene = MakeDataScene(std::make_shared<ExactField>(analytic::LinearRampField));
  scene.step = 3.0;
  scene.isosurfaces.push_back({ 0.3, Vector(1.0, 0.0, 0.0), 0.5 });
  scene.isosurfaces.push_back({ 0.7, Vector(0.0, 1.0, 0.0), 0.5 });
  glm::dvec4 pixel = PixelAt(scene, 0.0, 0.0); // the camera looks down z, the scalar falls
  check.Near("the first surface", pixel.g, 0.5, Rounding);
  check.Near("the second one", pixel.r, 0.25, Rounding);
  scene.color->RemoveAllPoints();
  scene.color->AddRGBPoint(0.0, 0.0, 0.0, 1.0);
  AddPeak(scene, 0.5, 0.1, 0.5);
  pixel = PixelAt(scene, 0.0, 0.0);
  check.Near("a peak between them", pixel.b, 0.25, 1e-6);
  check.Near("the surface behind it", pixel.r, 0.125, 1e-6);
}

double CosineOnSphere(double distance)
{
  return std::sqrt(1.0 - distance * distance / 0.25);
}

// A sphere, seen at an angle: eq. 15 and eq. 16 at each of two crossings.
void TestSilhouettes(Check& check)
{
  Scene scene = MakeDataScene(std::make_shared<ExactField>(analytic::SphereField));
  const double opacity = 0.2;
  scene.step = 1.0 / 512.0; // shorter than the chord of the last ray
  scene.isosurfaces.push_back({ 0.5, Vector(1.0), opacity });
  for (double x : { 0.0, 0.2, 0.4, 0.49, 0.4999 })
  {
    const double cosine = CosineOnSphere(x);
    scene.silhouette = Silhouette::Off;
    check.Near("without silhouettes", PixelAt(scene, x, 0.0).a, 1.0 - 0.8 * 0.8, Rounding);
    const double exact = 1.0 - std::pow(1.0 - opacity, 2.0 / cosine);
    for (Silhouette form : { Silhouette::Exact, Silhouette::Gradient })
    {
      scene.silhouette = form;
      check.Near("eq. 15", PixelAt(scene, x, 0.0).a, exact, 1e-9);
    }
    scene.silhouette = Silhouette::Clamped;
    const double one = std::min(1.0, opacity / cosine);
    check.Near("eq. 16", PixelAt(scene, x, 0.0).a, one + (1.0 - one) * one, 1e-9);
  }
}

// A peak that is narrow enough is the surface of its opacity.
void TestSmoothSilhouettes(Check& check)
{
  Scene scene = MakeDataScene(std::make_shared<ExactField>(analytic::SphereField));
  AddPeak(scene, 0.5, 0.01, 0.2);
  scene.linearity = 1e-3;
  scene.step = 1.0 / 128.0;
  for (Silhouette form : { Silhouette::Off, Silhouette::Exact, Silhouette::Clamped })
  {
    scene.silhouette = form;
    for (double x : { 0.0, 0.2, 0.4 })
    {
      const double cosine = form == Silhouette::Off ? 1.0 : CosineOnSphere(x);
      const double exact = 1.0 - std::pow(0.8, 2.0 / cosine);
      const double one = std::min(1.0, 0.2 / cosine);
      const double expected = form == Silhouette::Clamped ? one + (1.0 - one) * one : exact;
      // segments of a tenth of the peak, each by its own opacity: eq. 16 has composed to nearly eq. 15
      check.Near("a narrow peak at an angle", PixelAt(scene, x, 0.0).a, expected,
        form == Silhouette::Clamped ? 0.05 : 0.005);
    }
  }
}

Scene LitFromBehind(double slope, const Vector& toLight)
{
  Scene scene = MakeDataScene(std::make_shared<SlopesField>(slope));
  scene.shade = true;
  scene.ambient = 0.0;
  scene.diffuse = 0.7;
  scene.specular = 0.0;
  scene.specularPower = 5.0;
  scene.lights[0].toLight = glm::normalize(toLight);
  scene.transmittedLight = TransmittedLight::Diffuse;
  return scene;
}

// A plane across the ray with the light behind it: kd c a (1 - a) |L.n|, eq. 19.
void TestTransmittedLight(Check& check)
{
  const Vector toLight = glm::normalize(Vector(0.5, 0.0, -1.0));
  const double specular = std::pow(-toLight.z, 5.0);
  for (double opacity : { 0.0, 0.3, 0.9, 1.0 })
  {
    Scene scene = LitFromBehind(0.0, toLight);
    scene.isosurfaces.push_back({ 0.5, Vector(0.5), opacity });
    const double factor = 0.7 * 0.5 * opacity * (1.0 - opacity);
    check.Near("diffuse", PixelAt(scene, 0.0, 0.0).r, factor * -toLight.z, 1e-9);
    scene.transmittedLight = TransmittedLight::DiffuseAndSpecular;
    check.Near("specular", PixelAt(scene, 0.0, 0.0).r, factor * (-toLight.z + specular), 1e-9);
    scene.lights[0].toLight = -toLight;
    check.Near("light from the front is reflected", PixelAt(scene, 0.0, 0.0).r,
      0.7 * 0.5 * opacity * -toLight.z, 1e-9);
    scene.reflectance = Reflectance::None;
    check.Near("by the model without a surface, too", PixelAt(scene, 0.0, 0.0).r, 0.7 * 0.5 * opacity, 1e-9);
  }
}

// A smooth peak transmits what the surface of its opacity does, at any step.
void TestSmoothTransmission(Check& check)
{
  for (double opacity : { 0.3, 0.5, 0.9 })
  {
    Scene scene = LitFromBehind(0.0, Vector(0.0, 0.0, -1.0));
    AddPeak(scene, 0.5, 0.2, opacity);
    for (double step : { 1.0 / 128.0, 1.0 / 32.0, 0.3, 3.0 })
    {
      scene.step = step;
      const double expected = 0.7 * 0.8 * opacity * (1.0 - opacity);
      const std::string what = "a peak of " + std::to_string(opacity) + ", step " + std::to_string(step);
      check.Near(what, PixelAt(scene, 0.0, 0.0).b, expected, 1e-6);
    }
  }
}
}

int TestReferenceSurfaces(int, char*[])
{
  Check check;
  TestUniformOpacity(check);
  TestOrder(check);
  TestSilhouettes(check);
  TestSmoothSilhouettes(check);
  TestTransmittedLight(check);
  TestSmoothTransmission(check);
  return check.ExitCode();
}
