// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The reference renderer in data space and pre-integrated: closed forms, independence of step and scale,
// the limit of many isosurfaces.

#include "DataSpaceScenes.h"

#include <string>
#include <vector>

using namespace reference;
using namespace scenes;

namespace
{
// The quadrature's tolerance in a scene.
constexpr double Quadrature = 1e-6;

// A peak of opacity one half has it on every ray across it, whatever slope, step and scale; in physical
// space it has not.
void TestPeak(Check& check)
{
  Scene scene = MakeDataScene(std::make_shared<SlopesField>(1.0));
  AddPeak(scene, 0.5, 0.05, 0.5);
  for (double scale : { 1e-6, 1.0, 1e6 })
  {
    for (double step : { 1.0 / 128.0, 1.0 / 32.0, 0.21, 3.0 })
    {
      scene.step = step;
      const Scene scaled = Scaled(scene, scale);
      for (double x : { -0.9, -0.3, 0.4, 0.97 })
      {
        const glm::dvec4 pixel = PixelAt(scaled, x, 0.0);
        const std::string what = "scale " + std::to_string(scale) + ", step " + std::to_string(step);
        check.Near(what + ", opacity", pixel.a, 0.5, Quadrature);
        check.Near(what + ", colour", pixel.b, 0.8 * 0.5, Quadrature);
      }
    }
  }
  scene.integrationSpace = IntegrationSpace::Physical;
  scene.step = 1.0 / 32.0;
  const double flat = PixelAt(scene, -0.9, 0.0).a;
  const double steep = PixelAt(scene, 0.97, 0.0).a;
  check.AtLeast("in physical space a flat slope is more opaque", flat, 2.0 * steep);
}

// A post-classified ray tends to the same with the step.
void TestPostClassified(Check& check)
{
  Scene scene = MakeDataScene(std::make_shared<SlopesField>(0.5));
  AddPeak(scene, 0.5, 0.2, 0.5);
  scene.classification = Classification::Post;
  for (double x : { -0.8, 0.1, 0.9 })
  {
    scene.step = 1.0 / 2000.0;
    check.Near("post-classified", PixelAt(scene, x, 0.0).a, 0.5, 0.002);
    scene.step = 1.0 / 8.0;
    check.That(std::abs(PixelAt(scene, x, 0.0).a - 0.5) > 1e-3, "a long step shows");
  }
}

// Charges of other strengths are scaled copies: a ray at the same relative distance sees the same.
void TestCoulombPotentials(Check& check)
{
  std::vector<glm::dvec4> inData;
  std::vector<glm::dvec4> inSpace;
  for (double strength : { 0.2, 0.1, 0.05 })
  {
    analytic::Parameters parameters;
    parameters.strength = strength;
    Scene scene = MakeDataScene(std::make_shared<ExactField>(analytic::CoulombPotentialField, parameters));
    AddPeak(scene, 0.5, 0.2, 0.3);
    scene.linearity = 1e-4;
    scene.step = 1.0 / 64.0;
    inData.push_back(PixelAt(scene, 0.4 * strength, 0.3 * strength));
    scene.integrationSpace = IntegrationSpace::Physical;
    inSpace.push_back(PixelAt(scene, 0.4 * strength, 0.3 * strength));
  }
  check.Near("across the peak and back", inData[0].a, 1.0 - 0.7 * 0.7, 0.05);
  for (int i = 1; i < 3; ++i)
  {
    check.Near("charges look alike", inData[i].a, inData[0].a, 1e-3);
    check.AtMost("not so in physical space", inSpace[i].a, 0.7 * inSpace[i - 1].a);
  }
}

double TotalVariation(const Scene& scene, double x, double y)
{
  const int count = 100000;
  double sum = 0.0;
  double former = scene.field->Value(Vector(x, y, 1.0));
  for (int i = 1; i <= count; ++i)
  {
    const double value = scene.field->Value(Vector(x, y, 1.0 - 2.0 * i / count));
    sum += std::abs(value - former);
    former = value;
  }
  return sum;
}

// A constant function shows where the data changes, by its total variation along the ray, and nothing where
// it is constant; N isosurfaces of opacity 1/N tend to it.
void TestConstantFunction(Check& check)
{
  Scene none = MakeDataScene(std::make_shared<ConstantField>());
  none.opacity->AddPoint(0.0, 0.9);
  check.Near("a constant volume", PixelAt(none, 0.0, 0.0).a, 0.0, 0.0);

  Scene scene = MakeDataScene(std::make_shared<ExactField>(analytic::TorusField));
  scene.linearity = 1e-5;
  scene.opacity->AddPoint(0.0, 0.7);
  const double x = 0.31;
  const double y = 0.4;
  const double depth = -std::log(0.3) * TotalVariation(scene, x, y);
  const double continuous = PixelAt(scene, x, y).a;
  check.Near("opacity by the total variation", continuous, -std::expm1(-depth), 1e-4);

  scene.opacity->AddPoint(0.0, 0.0);
  for (int count : { 16, 64, 256 })
  {
    scene.isosurfaces.clear();
    for (int i = 0; i < count; ++i)
    {
      scene.isosurfaces.push_back({ (i + 0.5) / count, Vector(1.0), -std::log(0.3) / count });
    }
    const double error = std::abs(PixelAt(scene, x, y).a - continuous);
    std::cout << count << " isosurfaces: " << error << " from the continuous integral" << std::endl;
    // each of the four parts on which the scalar is monotone may cross one more or less
    check.AtMost("isosurfaces converge", error, 4.0 * -std::log(0.3) / count * (1.0 - continuous));
  }
}

// In physical space the ramp of TestReferenceIntegral is exact at any step: opacity a s along s = 0 to 1 over
// a length of 2.
void TestPhysicalSpace(Check& check)
{
  Scene scene = MakeScene(std::make_shared<ExactField>(analytic::LinearRampField), 4);
  const double a = 0.8;
  scene.opacity->AddPoint(0.0, 0.0);
  scene.opacity->AddPoint(1.0, a);
  scene.classification = Classification::PreIntegrated;
  const double depth = 2.0 * ((1.0 - a) * std::log(1.0 - a) + a) / a;
  for (double step : { 0.01, 0.3, 2.0 })
  {
    for (double firstSample : { 0.5, 1.0 })
    {
      scene.step = step;
      scene.firstSample = firstSample;
      const glm::dvec4 pixel = PixelAt(scene, 0.0, 0.0);
      check.Near("a pre-integrated ramp", pixel.a, -std::expm1(-depth), Quadrature);
      check.Near("its colour", pixel.r, 0.2 * pixel.a, Quadrature);
    }
  }
  // where the scalar does not change, physical space still has an opacity
  Scene constant = MakeScene(std::make_shared<ConstantField>(), 4);
  constant.opacity->AddPoint(0.0, 0.3);
  constant.classification = Classification::PreIntegrated;
  check.Near("a constant volume", PixelAt(constant, 0.0, 0.0).a, 1.0 - 0.7 * 0.7, Quadrature);
}

// What segments are pre-integrated over does not matter: neither does an end in the middle of a peak.
void TestEnds(Check& check)
{
  Scene scene = MakeDataScene(std::make_shared<ExactField>(analytic::LinearRampField));
  AddPeak(scene, 0.0, 0.25, 0.75);
  check.Near("half of a peak at the volume's face", PixelAt(scene, 0.0, 0.0).a, 0.5, Quadrature);
  scene.opacity->AddPoint(5.0, 1.0);
  scene.unitInterval = 1e-8;
  check.Near("opaque", PixelAt(scene, 0.0, 0.0).a, 1.0, 0.0);
  scene.terminatesEarly = true;
  check.AtLeast("early termination", PixelAt(scene, 0.0, 0.0).a, 1.0 - 1.0 / 255.0);
}
}

int TestReferenceDataSpace(int, char*[])
{
  Check check;
  TestPeak(check);
  TestPostClassified(check);
  TestCoulombPotentials(check);
  TestConstantFunction(check);
  TestPhysicalSpace(check);
  TestEnds(check);
  return check.ExitCode();
}
