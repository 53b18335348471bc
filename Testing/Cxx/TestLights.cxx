// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every kind of VTK's lights: the highlight of a sphere lies where the normal is the half vector, and
// has the light's colour and attenuation.

#include "TestScene.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"

#include <array>

namespace
{
using Vector = std::array<double, 3>;

const double Radius = 0.5;
const double ParallelScale = 0.75;

// An opaque sphere seen along +y, whose samples show nothing but the highlight.
struct SphereScene : TestScene
{
  SphereScene()
  {
    this->Source->SetFieldToSphere();
    this->Source->SetDimensions(48, 48, 48);
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.45, 0.0);
    this->Opacity->AddPoint(0.55, 0.95);
    this->Property->SetReflectanceModelToBlinnPhong();
    this->Property->SetGlossiness(60.0);
    this->Property->SetAmbient(0.0);
    this->Property->SetDiffuse(0.0);
    this->Property->SetSpecular(1.0);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -3.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(ParallelScale);
    this->Renderer->ResetCameraClippingRange();
    this->Renderer->SetAutomaticLightCreation(false);
  }

  vtkLight* Add(const Vector& position, bool positional)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(position.data());
    light->SetPositional(positional);
    light->SetConeAngle(180.0);
    this->Renderer->AddLight(light);
    return light;
  }
};

Vector Normalized(Vector v)
{
  vtkMath::Normalize(v.data());
  return v;
}

// Where N = H: found by repetition, since a positional light's direction depends on the point.
Vector HighlightNormal(const Vector& position, bool positional)
{
  Vector normal = { 0.0, -1.0, 0.0 };
  for (int i = 0; i < 50; ++i)
  {
    Vector toLight = position;
    for (int axis = 0; axis < 3 && positional; ++axis)
    {
      toLight[axis] -= Radius * normal[axis];
    }
    toLight = Normalized(toLight);
    normal = Normalized({ toLight[0], toLight[1] - 1.0, toLight[2] });
  }
  return normal;
}

// Pixel coordinates of the centre of brightness.
std::array<double, 2> Centre(const std::vector<float>& pixels, int width)
{
  double sum = 0.0, x = 0.0, y = 0.0;
  for (std::size_t i = 0; i < pixels.size() / 4; ++i)
  {
    const double weight = std::pow(pixels[4 * i + 1], 4);
    sum += weight;
    const std::size_t column = i % width;
    const std::size_t row = i / width;
    x += weight * static_cast<double>(column);
    y += weight * static_cast<double>(row);
  }
  return { x / sum + 0.5, y / sum + 0.5 };
}

double Sum(const std::vector<float>& pixels, int channel)
{
  double sum = 0.0;
  for (std::size_t i = channel; i < pixels.size(); i += 4)
  {
    sum += pixels[i];
  }
  return sum;
}

void CheckPosition(Check& check, const std::string& name, const Vector& position, bool positional)
{
  SphereScene scene;
  scene.Add(position, positional);
  const std::array<double, 2> centre = Centre(scene.RenderFloat(), 150);
  const Vector normal = HighlightNormal(position, positional);
  const double perPixel = 2.0 * ParallelScale / 150.0;
  const double x = 75.0 + Radius * normal[0] / perPixel;
  const double y = 75.0 + Radius * normal[2] / perPixel;
  // a pixel and a half: the cosine of the light moves the centre of the lobe inwards a little
  check.That(std::hypot(centre[0] - x, centre[1] - y) < 1.5,
    name + ": highlight at " + std::to_string(centre[0]) + ", " + std::to_string(centre[1]) + ", not " +
      std::to_string(x) + ", " + std::to_string(y));
}

void CheckAttenuation(Check& check)
{
  const Vector position = { 0.0, -4.0, 0.0 };
  SphereScene plain, attenuated, outside;
  plain.Add(position, true);
  attenuated.Add(position, true)->SetAttenuationValues(0.0, 0.0, 1.0);
  vtkLight* spot = outside.Add({ 3.0, -4.0, 0.0 }, true);
  spot->SetConeAngle(10.0);
  spot->SetFocalPoint(6.0, -4.0, 0.0);
  const double ratio = Sum(attenuated.RenderFloat(), 1) / Sum(plain.RenderFloat(), 1);
  // the highlight lies 3.5 from the light
  check.That(std::abs(ratio - 1.0 / 12.25) < 0.002, "quadratic attenuation: " + std::to_string(ratio));
  check.That(Sum(outside.RenderFloat(), 1) == 0.0, "a spot light lights what is outside of its cone");
}

void CheckColorAndSum(Check& check)
{
  SphereScene left, right, both, none;
  const auto addLeft = [](SphereScene& scene) {
    scene.Add({ -3.0, -3.0, 0.0 }, false)->SetColor(1.0, 0.0, 0.0);
  };
  const auto addRight = [](SphereScene& scene) { scene.Add({ 3.0, -3.0, 1.0 }, false)->SetIntensity(0.5); };
  addLeft(left);
  addRight(right);
  addLeft(both);
  addRight(both);
  const std::vector<float> a = left.RenderFloat(), b = right.RenderFloat(), sum = both.RenderFloat();
  double largest = 0.0;
  for (std::size_t i = 0; i < sum.size(); i += 4)
  {
    largest = std::max(largest, std::abs(double(sum[i]) - a[i] - b[i]));
  }
  check.That(Sum(a, 0) > 1.0 && Sum(a, 1) == 0.0, "a red light gives a highlight that is not red");
  check.That(largest < 1.0e-4, "two lights differ from the sum of each by " + std::to_string(largest));
  check.That(Sum(none.RenderFloat(), 0) == 0.0, "without a light there is light");
}

// What is seen through a translucent sphere is its far side from within.
void CheckTwoSided(Check& check)
{
  SphereScene scene;
  scene.Add({ 0.0, -3.0, 0.0 }, false);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.45, 0.0);
  scene.Opacity->AddPoint(0.55, 0.05);
  const double twoSided = Sum(scene.RenderFloat(), 1);
  scene.Renderer->TwoSidedLightingOff();
  const double oneSided = Sum(scene.RenderFloat(), 1);
  check.That(twoSided > 1.2 * oneSided && oneSided > 0.0,
    "two-sided " + std::to_string(twoSided) + ", one-sided " + std::to_string(oneSided));
}

// A light that moves with the camera gives the same picture from every side of a sphere.
void CheckCameraLight(Check& check)
{
  SphereScene scene;
  vtkLight* light = scene.Add({ 1.0, 1.0, 1.0 }, false);
  light->SetLightTypeToCameraLight();
  const double front = Sum(scene.RenderFloat(), 1);
  scene.Renderer->GetActiveCamera()->Azimuth(90.0);
  const double side = Sum(scene.RenderFloat(), 1);
  check.That(std::abs(front / side - 1.0) < 0.01, "a camera light does not follow the camera");
}

// VTK 9.1 has room for six lights; a seventh is left out, with one warning, and stays switched on.
void CheckManyLights(Check& check)
{
  SphereScene scene;
  Warnings warnings(scene.Optics);
  for (int i = 0; i < 9; ++i)
  {
    scene.Add({ i - 4.0, -3.0, 0.0 }, false);
  }
  check.That(AreFinite(scene.RenderFloat()), "nine lights: a pixel is not finite");
  auto* last = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(8));
  check.That(last->GetSwitch() != 0, "the ninth light is left switched off");
  check.That(warnings.Texts.size() <= 1, "nine lights: said more than once");
}
}

int TestLights(int, char*[])
{
  Check check;
  CheckPosition(check, "directional, in front", { 0.0, -1.0, 0.0 }, false);
  CheckPosition(check, "directional, from the right", { 2.0, -2.0, 0.0 }, false);
  CheckPosition(check, "directional, from above", { 0.5, -2.0, 2.0 }, false);
  CheckPosition(check, "positional, from the right", { 1.5, -1.5, 0.0 }, true);
  CheckPosition(check, "positional, from below", { 0.5, -2.0, -1.5 }, true);
  CheckAttenuation(check);
  CheckColorAndSum(check);
  CheckTwoSided(check);
  CheckCameraLight(check);
  CheckManyLights(check);
  return check.ExitCode();
}
