// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The reference renderer's shading: highlights, the extinction's gradient, frames, extremes.

#include "Optics.h"
#include "ReferenceScenes.h"
#include "Shading.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdlib>

using namespace reference;
using namespace scenes;

namespace
{
std::shared_ptr<ExactField> MakeSphere()
{
  return std::make_shared<ExactField>(analytic::SphereField);
}

void KeepSpecularOnly(Scene& scene)
{
  scene.shade = true;
  scene.ambient = 0.0;
  scene.diffuse = 0.0;
  scene.specular = 1.0;
}

// The brightest pixel of a glossy sphere lies where N = H.
void TestHighlightOfSphere(Check& check)
{
  const int size = 100;
  Scene scene = MakeScene(MakeSphere(), size);
  ShowSurface(scene);
  KeepSpecularOnly(scene);
  scene.reflectance = Reflectance::BlinnPhong;
  scene.glossiness = 2000.0;
  for (const Vector& light : { Vector(0.0, 0.0, 1.0), Vector(1.0, 0.0, 1.0), Vector(-1.0, 2.0, 1.0) })
  {
    scene.lights[0].toLight = glm::normalize(light);
    const Vector half = glm::normalize(scene.lights[0].toLight + Vector(0.0, 0.0, 1.0));
    const Image image = Render(scene);
    int brightest = 0;
    for (int i = 0; i < size * size; ++i)
    {
      brightest = image.pixels[i].r > image.pixels[brightest].r ? i : brightest;
    }
    const double x = (brightest % size + 0.5) / size * 2.0 - 1.0;
    const int row = brightest / size;
    const double y = (row + 0.5) / size * 2.0 - 1.0;
    check.That(image.pixels[brightest].r > 0.1, "the sphere has a highlight");
    check.That(std::hypot(x - 0.5 * half.x, y - 0.5 * half.y) < 0.04, "the highlight lies at N = H");
  }
}

// N points to the lower extinction, however opacity runs with the scalar; both estimates agree with
// K = D |tau'(s)| |grad s|.
void TestExtinctionGradient(Check& check)
{
  Scene scene = MakeScene(MakeSphere(), 4);
  scene.grid = Cube(512);
  scene.unitDistance = 0.05;
  Sample sample;
  sample.position = glm::normalize(Vector(1.0, -2.0, 0.5)) * 0.5;
  sample.toViewer = Vector(0.0, 0.0, 1.0);
  sample.scalar = scene.field->Value(sample.position);
  const Vector outwards = glm::normalize(sample.position);
  for (double slope : { 0.5, -0.5 })
  {
    scene.opacity->RemoveAllPoints();
    scene.opacity->AddPoint(0.0, 0.3 - 0.5 * slope);
    scene.opacity->AddPoint(1.0, 0.3 + 0.5 * slope);
    const double opacity = scene.Opacity(sample.scalar);
    const double magnitude = glm::length(scene.field->Gradient(sample.position));
    const double expected = scene.unitDistance * std::abs(slope) / (1.0 - opacity) * magnitude;
    for (GradientEstimate estimate : { GradientEstimate::StoredNormal, GradientEstimate::CentralDifferences })
    {
      scene.gradientEstimate = estimate;
      const ExtinctionGradient gradient = ExtinctionGradientAt(scene, sample);
      const Vector normal = slope > 0.0 ? outwards : -outwards;
      check.That(glm::length(gradient.normal - normal) < 1.0e-3, "the extinction's normal");
      check.That(std::abs(gradient.coefficient / expected - 1.0) < 1.0e-3, "the specular coefficient");
    }
  }
  scene.specularFromExtinction = false;
  check.That(ExtinctionGradientAt(scene, sample).coefficient == 1.0, "K = 1 when off");
}

// A light behind a surface is reflected if lighting is two-sided only.
void TestTwoSided(Check& check)
{
  Scene scene = MakeScene(MakeSphere(), 4);
  ShowSurface(scene);
  KeepSpecularOnly(scene);
  scene.reflectance = Reflectance::BlinnPhong;
  scene.glossiness = 1.0;
  scene.lights[0].toLight = glm::normalize(Vector(1.0, 0.0, -0.2));
  Sample sample;
  sample.position = Vector(0.0, 0.0, 0.5);
  sample.toViewer = glm::normalize(Vector(1.0, 0.0, -0.2));
  sample.scalar = 0.5;
  check.That(Radiance(scene, sample).r > 0.0, "two-sided light falls on the back");
  scene.twoSided = false;
  check.That(Radiance(scene, sample).r == 0.0, "one-sided light does not");
}

// What the phase function alone scatters: c (ka + kd HG).
void TestPhaseFunction(Check& check)
{
  Scene scene = MakeScene(MakeSphere(), 4);
  ShowSurface(scene);
  scene.shade = true;
  scene.reflectance = Reflectance::None;
  scene.scatteringAnisotropy = 0.5;
  scene.lights[0].toLight = Vector(0.0, 0.0, -1.0); // straight ahead: HG = (1 - g^2)/(1 - g)^3 = 6
  Sample sample;
  sample.position = Vector(0.0, 0.0, 0.5);
  sample.toViewer = Vector(0.0, 0.0, 1.0);
  sample.scalar = 0.5;
  const double expected = 0.5 * (0.1 + 0.7 * 6.0);
  check.That(std::abs(Radiance(scene, sample).g - expected) < 1.0e-12, "forward scattering");
}

// Attenuation and cone of a spot light; distances are the world's.
void TestPositionalLight(Check& check)
{
  Scene scene = MakeScene(MakeSphere(), 4);
  scene.shade = true;
  scene.ambient = 0.0;
  scene.diffuse = 1.0;
  scene.reflectance = Reflectance::None;
  Light& light = scene.lights[0];
  light.positional = true;
  light.position = Vector(0.0, 0.0, 2.5);
  light.coneAngle = 30.0;
  light.exponent = 2.0;
  light.attenuation = Vector(1.0, 0.5, 0.25);
  Sample sample;
  sample.position = Vector(0.0, 0.0, 0.5);
  sample.toViewer = Vector(0.0, 0.0, 1.0);
  check.That(std::abs(Radiance(scene, sample).g - 0.5 / 3.0) < 1.0e-12, "attenuation at distance 2");
  scene.worldScale = 2.0;
  check.That(std::abs(Radiance(scene, sample).g - 0.5 / 7.0) < 1.0e-12, "attenuation in the world");
  scene.worldScale = 1.0;
  const double angle = glm::radians(20.0);
  sample.position = light.position + 2.0 * Vector(std::sin(angle), 0.0, -std::cos(angle));
  const double spot = 0.5 / 3.0 * std::cos(angle) * std::cos(angle);
  check.That(std::abs(Radiance(scene, sample).g - spot) < 1.0e-12, "the cone's exponent");
  light.coneAngle = 19.0;
  check.That(Radiance(scene, sample).g == 0.0, "outside the cone");
}

// The three storages decode to what was encoded, next to the pole and away from it.
void TestStoredFrames(Check& check)
{
  for (const Vector& direction : { Vector(0.3, -0.5, 0.8), Vector(0.0, 0.0, 1.0), Vector(0.01, 0.0, -1.0) })
  {
    const Vector normal = glm::normalize(direction);
    const glm::dvec2 anisotropy(0.4, -0.3);
    const Vector components = optics::EncodeComponents(anisotropy);
    const Vector map = optics::EncodeMap(normal, anisotropy);
    const optics::WorldTensor tensor = optics::EncodeWorld(normal, anisotropy);
    const std::vector<double> codes[] = { { map.x, map.y, map.z },
      { components.x, components.y, components.z },
      { tensor.diagonal.x, tensor.diagonal.y, tensor.diagonal.z, tensor.mixed.x, tensor.mixed.y } };
    for (int storage = 0; storage < 3; ++storage)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(2, 2, 2);
      auto add = [&image](const char* name, const std::vector<double>& tuple) {
        vtkNew<vtkDoubleArray> array;
        array->SetName(name);
        array->SetNumberOfComponents(static_cast<int>(tuple.size()));
        array->SetNumberOfTuples(8);
        for (vtkIdType i = 0; i < 8; ++i)
        {
          array->SetTuple(i, tuple.data());
        }
        image->GetPointData()->AddArray(array);
      };
      add("Normals", { normal.x, normal.y, normal.z });
      add("GradientMagnitude", { 2.5 });
      add("AmbientCovariance", codes[storage]);
      const Frame frame =
        GridFrameField(image, image, static_cast<Storage>(storage)).At(Vector(0.2, 0.7, 0.4));
      check.That(glm::length(frame.anisotropy - anisotropy) < 1.0e-12, "the stored anisotropy");
      check.That(glm::length(frame.normal - normal) < 1.0e-12 && std::abs(frame.magnitude - 2.5) < 1.0e-12,
        "the stored normal");
    }
  }
}

// The anisotropy whose major axis is x, as it lies in the tangent plane.
glm::dvec2 AlongX(const Vector&, const Vector& normal)
{
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  const glm::dvec2 axis(basis.theta.x, basis.phi.x);
  const double length2 = glm::dot(axis, axis);
  const double strength = 0.2;
  return length2 > 0.0
    ? strength * glm::dvec2(axis.x * axis.x - axis.y * axis.y, 2.0 * axis.x * axis.y) / length2
    : glm::dvec2(0.0);
}

// Extent of the bright region along x over that along y.
double Elongation(const Image& image)
{
  double alongX = 0.0;
  double alongY = 0.0;
  for (int i = 0; i < image.width * image.height; ++i)
  {
    const double x = i % image.width + 0.5 - image.width / 2.0;
    const int row = i / image.width;
    const double y = row + 0.5 - image.height / 2.0;
    alongX += image.pixels[i].r * x * x;
    alongY += image.pixels[i].r * y * y;
  }
  return std::sqrt(alongX / alongY);
}

// Highlights are drawn out along the major axis, the more the larger gamma is.
void TestElongation(Check& check)
{
  auto field = MakeSphere();
  Scene scene = MakeScene(field, 64);
  scene.frames = std::make_shared<ExactFrameField>(field, AlongX);
  ShowSurface(scene);
  KeepSpecularOnly(scene);
  for (Reflectance model : { Reflectance::Ward, Reflectance::Lafortune })
  {
    scene.reflectance = model;
    scene.glossiness = model == Reflectance::Ward ? 0.15 : 60.0;
    double former = 0.0;
    for (double scale : { 0.0, 1.0, 3.0 })
    {
      scene.anisotropyScale = scale;
      const double elongation = Elongation(Render(scene));
      std::cout << (model == Reflectance::Ward ? "Ward" : "Lafortune") << ", gamma " << scale
                << ": elongation " << elongation << "\n";
      check.That(scale > 0.0 || std::abs(elongation - 1.0) < 0.01, "isotropic without gamma");
      check.That(elongation > former, "longer along the major axis with gamma");
      former = elongation;
    }
    check.That(former > 1.5, "drawn out along the major axis");
  }
}

// A picture does not depend on the world's unit of length.
void TestScaleInvariance(Check& check)
{
  Scene scene = MakeScene(MakeSphere(), 16);
  ShowSurface(scene);
  scene.shade = true;
  scene.reflectance = Reflectance::Ward;
  scene.glossiness = 0.2;
  const Image image = Render(scene);
  for (double scale : { 1.0e-6, 1.0e6 })
  {
    analytic::Parameters parameters;
    parameters.radius = 0.5 * scale;
    Scene scaled = scene;
    auto field = std::make_shared<ExactField>(analytic::SphereField, parameters);
    scaled.field = field;
    scaled.frames = std::make_shared<ExactFrameField>(field);
    scaled.grid.corner *= scale;
    for (double& spacing : scaled.grid.spacing)
    {
      spacing *= scale;
    }
    for (int column = 0; column < 3; ++column)
    {
      scaled.camera.deviceToDataset[column] *= scale;
    }
    scaled.unitDistance *= scale;
    scaled.step *= scale;
    const double difference = Compare(image, Render(scaled)).maximum;
    check.That(difference < 1.0e-9, "the picture is the same at any scale");
  }
}

// Every model, at the ends of its ranges: finite, not negative, opacity in [0, 1].
void TestExtremes(Check& check)
{
  auto field = std::make_shared<ExactField>(analytic::VortexTubesField);
  Scene scene = MakeScene(field, 12);
  scene.frames = std::make_shared<ExactFrameField>(
    field, [](const Vector& p, const Vector&) { return glm::dvec2(std::sin(9.0 * p.x), 0.0) * 0.9999; });
  scene.opacity->AddPoint(0.2, 0.0);
  scene.opacity->AddPoint(0.6, 1.0);
  scene.shade = true;
  for (const Vector& light : { Vector(0.0, 0.0, 1.0), Vector(0.0, 0.0, -1.0), Vector(1.0, 0.0, 0.0) })
  {
    scene.lights[0].toLight = light;
    for (int model = 0; model < 5; ++model)
    {
      scene.reflectance = static_cast<Reflectance>(model);
      const bool isWard = scene.reflectance == Reflectance::Ward;
      for (double glossiness : { isWard ? 1.0e-4 : 0.01, isWard ? 1.0 : 1.0e5 })
      {
        for (double scale : { 0.0, 10.0, 1.0e4 })
        {
          scene.glossiness = glossiness;
          scene.anisotropyScale = scale;
          for (const glm::dvec4& pixel : Render(scene).pixels)
          {
            const double sum = pixel.r + pixel.g + pixel.b;
            check.That(std::isfinite(sum) && sum >= 0.0 && pixel.a >= 0.0 && pixel.a <= 1.0,
              "a finite, positive picture");
          }
        }
      }
    }
  }
}
}

int TestReferenceShading(int, char*[])
{
  Check check;
  TestHighlightOfSphere(check);
  TestExtinctionGradient(check);
  TestTwoSided(check);
  TestPhaseFunction(check);
  TestPositionalLight(check);
  TestStoredFrames(check);
  TestElongation(check);
  TestScaleInvariance(check);
  TestExtremes(check);
  return check.ExitCode();
}
