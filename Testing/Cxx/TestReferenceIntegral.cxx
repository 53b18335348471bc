// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The reference renderer's integral: closed forms and its order of convergence.

#include "ReferenceScenes.h"
#include "vtkAnalyticVolumeSource.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdlib>

using namespace reference;
using namespace scenes;

namespace
{
bool IsNear(double a, double b, double tolerance)
{
  return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b));
}

// Lambert-Beer: alpha = 1 - (1 - a)^(L/D), whatever the step. The series of OneMinusExp() ends at an
// error of x^3/24 for an optical depth x below 0.01: 4e-8 at most.
void TestHomogeneousMedium(Check& check)
{
  Scene scene = MakeScene(std::make_shared<ConstantField>(), 4);
  scene.opacity->AddPoint(0.0, 0.3);
  scene.unitDistance = 0.7;
  const double alpha = 1.0 - std::pow(0.7, 2.0 / 0.7);
  for (double firstSample : { 0.5, 1.0 })
  {
    for (int count : { 1, 2, 10, 1000, 100000 })
    {
      scene.firstSample = firstSample;
      scene.step = 2.0 / count;
      const glm::dvec4 pixel = IntegrateRay(scene, RayThrough(scene, 2.0, 2.0));
      check.That(IsNear(pixel.a, alpha, 4.0e-8), "opacity of a homogeneous medium");
      check.That(IsNear(pixel.g, 0.5 * alpha, 4.0e-8), "colour of a homogeneous medium");
    }
  }
  // an opaque material is opaque at any step
  scene.opacity->AddPoint(0.0, 1.0);
  check.That(IntegrateRay(scene, RayThrough(scene, 2.0, 2.0)).a == 1.0, "opaque stays opaque");
}

void TestEarlyTermination(Check& check)
{
  Scene scene = MakeScene(std::make_shared<ConstantField>(), 4);
  scene.opacity->AddPoint(0.0, 0.9);
  scene.unitDistance = 0.1;
  const glm::dvec4 whole = IntegrateRay(scene, RayThrough(scene, 2.0, 2.0));
  scene.terminatesEarly = true;
  const glm::dvec4 early = IntegrateRay(scene, RayThrough(scene, 2.0, 2.0));
  check.That(early.a > 1.0 - 1.0 / 255.0 && early.a < whole.a && whole.a - early.a < 1.0 / 255.0,
    "early termination loses less than 1/255");
}

// Opacity a s along a ramp s = 0 to 1 over length 2: tau = 2/D int -ln(1 - a s) ds
// = 2/D ((1 - a) ln(1 - a) + a)/a. The midpoint rule converges with the square of the step.
void TestRamp(Check& check)
{
  Scene scene = MakeScene(std::make_shared<ExactField>(analytic::LinearRampField), 4);
  const double a = 0.8;
  scene.opacity->AddPoint(0.0, 0.0);
  scene.opacity->AddPoint(1.0, a);
  const double tau = 2.0 * ((1.0 - a) * std::log(1.0 - a) + a) / a;
  double formerError = 0.0;
  for (int count : { 8, 16, 32, 64 })
  {
    scene.step = 2.0 / count;
    const double alpha = IntegrateRay(scene, RayThrough(scene, 2.0, 2.0)).a;
    const double error = std::abs(-std::log(1.0 - alpha) - tau);
    if (formerError > 0.0)
    {
      check.That(IsNear(formerError / error, 4.0, 0.05), "second order on a ramp");
    }
    formerError = error;
  }
  check.That(formerError < 1.0e-3, "the ramp's optical depth");
}

// Successive differences fall by 4 as the step is halved.
void TestMarschnerLobb(Check& check)
{
  Scene scene = MakeScene(std::make_shared<ExactField>(analytic::MarschnerLobbField), 24);
  scene.opacity->AddPoint(0.0, 0.0);
  scene.opacity->AddPoint(1.0, 0.6);
  scene.color->AddRGBPoint(0.0, 0.0, 0.2, 1.0);
  scene.color->AddRGBPoint(1.0, 1.0, 0.5, 0.1);
  scene.step = 1.0 / 16.0;
  Image former = Render(scene);
  double formerDifference = 0.0;
  for (int halving = 0; halving < 4; ++halving)
  {
    scene.step /= 2.0;
    Image image = Render(scene);
    const double difference = Compare(image, former).rootMeanSquare;
    std::cout << "Marschner-Lobb, step " << scene.step << ": rms change " << difference << "\n";
    if (halving > 0)
    {
      check.That(IsNear(formerDifference / difference, 4.0, 0.1), "second order on Marschner-Lobb");
    }
    formerDifference = difference;
    former = image;
  }
}

// Outside the volume, and the parts of a ray in front of the camera only.
void TestRays(Check& check)
{
  Scene scene = MakeScene(std::make_shared<ConstantField>(), 4);
  scene.opacity->AddPoint(0.0, 0.3);
  Ray outside = RayThrough(scene, 2.0, 2.0);
  outside.inside = Intersect(scene.grid, Vector(3.0, 0.0, 5.0), outside.direction);
  check.That(IntegrateRay(scene, outside).a == 0.0, "a ray beside the volume");
  scene.camera.deviceToDataset[2][2] = -1.0;
  scene.camera.deviceToDataset[3][2] = -1.0; // near plane z = 0: half of the volume
  scene.step = 0.01;
  const double alpha = IntegrateRay(scene, RayThrough(scene, 2.0, 2.0)).a;
  check.That(IsNear(alpha, 1.0 - 0.7, 1.0e-9), "a camera inside the volume");
}

// The samples of an image: exact on a linear field, also turned, clamped outside.
void TestGridField(Check& check)
{
  vtkNew<vtkAnalyticVolumeSource> source;
  source->SetFieldToLinearRamp();
  source->SetAxis(1.0, 2.0, 3.0);
  source->SetDimensions(9, 7, 5);
  source->SetOutputScalarType(VTK_DOUBLE);
  source->Update();
  const GridField field(source->GetOutput());
  const ExactField exact(analytic::LinearRampField, [] {
    analytic::Parameters parameters;
    parameters.axis = { 1.0, 2.0, 3.0 };
    return parameters;
  }());
  const Vector p(0.13, -0.37, 0.41);
  check.That(IsNear(field.Value(p), exact.Value(p), 1.0e-14), "interpolation of a linear field");
  check.That(glm::length(field.Gradient(p) - exact.Gradient(p)) < 1.0e-13, "its gradient");
  check.That(IsNear(field.Value(Vector(-5.0)), exact.Value(Vector(-1.0)), 1.0e-14), "clamped outside");
  // a quarter turn about z: x of the grid runs along y
  source->GetOutput()->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  const GridField turned(source->GetOutput());
  const Vector origin(-1.0);
  const Vector local(0.3, 0.5, 0.7);
  const Vector moved = origin + Vector(-local.y, local.x, local.z);
  check.That(IsNear(turned.Value(moved), exact.Value(origin + local), 1.0e-14), "a direction matrix");
  const Vector gradient = exact.Gradient(p);
  const Vector expected(-gradient.y, gradient.x, gradient.z);
  check.That(glm::length(turned.Gradient(moved) - expected) < 1.0e-13, "the turned gradient");
}
}

int TestReferenceIntegral(int, char*[])
{
  Check check;
  TestHomogeneousMedium(check);
  TestEarlyTermination(check);
  TestRamp(check);
  TestMarschnerLobb(check);
  TestRays(check);
  TestGridField(check);
  return check.ExitCode();
}
