// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows of the mapper: none where they are off, what links a program, how often is swept, many lights,
// clipping planes, scales of the world, opaque geometry.

#include "ShadowScene.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

#include <functional>
#include <map>
#include <numeric>
#include <string>

namespace
{
double Brightness(const std::vector<unsigned char>& pixels)
{
  return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

// Off, or with nobody to cast them: no text, no texture.
void CheckOff(Check& check)
{
  ShadowScene scene;
  vtkLight* sun = scene.AddSun(1.0, 0.0, 1.0);
  scene.Property->ShadowsOff();
  const std::vector<unsigned char> lit = scene.Render();
  const unsigned long memory = scene.Optics->GetTermMemorySize();
  check.That(
    scene.Optics->GetActiveTerms() == "Reflectance", "shadows off: " + scene.Optics->GetActiveTerms());
  check.That(scene.Optics->GetFragmentShader().find("Shadow") == std::string::npos &&
      scene.Optics->GetFragmentShader().find("OPTICS_SWEEP") == std::string::npos,
    "shadows off: text of shadows");
  scene.Property->ShadowsOn();
  const std::vector<unsigned char> shadowed = scene.Render();
  check.That(
    scene.Optics->GetActiveTerms() == "Reflectance,Shadows", "on: " + scene.Optics->GetActiveTerms());
  check.AtLeast("textures of shadows", scene.Optics->GetTermMemorySize(), memory + 100.0);
  check.AtMost("brightness with shadows", Brightness(shadowed), 0.8 * Brightness(lit));
  sun->SetShadowAttenuation(0.0F);
  check.That(scene.Render() == lit, "a light that casts no shadow differs from shadows off");
  check.That(
    scene.Optics->GetActiveTerms() == "Reflectance", "nobody casts: " + scene.Optics->GetActiveTerms());
  check.That(scene.Optics->GetTermMemorySize() == memory, "nobody casts: textures are left");
}

// VTK's model with shadows is drawn by the terms; unshaded there are no lights.
void CheckModels(Check& check)
{
  ShadowScene scene;
  scene.AddSun(1.0, 0.0, 1.0);
  scene.Property->SetReflectanceModelToVTK();
  const double shadowed = Brightness(scene.Render());
  check.That(
    scene.Optics->GetActiveTerms() == "Reflectance,Shadows", "VTK: " + scene.Optics->GetActiveTerms());
  scene.Property->ShadowsOff();
  check.AtMost("VTK's model with shadows", shadowed, 0.9 * Brightness(scene.Render()));
  check.That(
    scene.Optics->GetActiveTerms().empty(), "VTK's model without: " + scene.Optics->GetActiveTerms());
  scene.Property->ShadowsOn();
  scene.Property->ShadeOff();
  scene.Render();
  check.That(scene.Optics->GetActiveTerms().empty(), "unshaded: " + scene.Optics->GetActiveTerms());
}

// Whatever evaluates the light gets what is left of it.
void CheckEvaluations(Check& check)
{
  using Property = vtkOpticsVolumeProperty;
  std::map<std::string, std::function<void(ShadowScene&)>> evaluations;
  for (const int model : { Property::BlinnPhong, Property::Ward, Property::Lafortune })
  {
    evaluations["model " + std::to_string(model)] = [=](ShadowScene& s) {
      s.Property->SetReflectanceModel(model);
      s.Property->SetSpecular(0.5);
    };
  }
  evaluations["lighting table"] = [](ShadowScene& s) { LightEverywhere(s, 0.0, 0.8, 0.0); };
  evaluations["transmitted light"] = [](ShadowScene& s) {
    s.Property->SetIntegrationSpaceToData();
    s.Property->SetScalarOpacityUnitInterval(0.2);
    s.Property->SetTransmittedLightToDiffuse();
  };
  for (const auto& [name, apply] : evaluations)
  {
    ShadowScene scene;
    scene.AddSun(1.0, 0.0, 1.0);
    apply(scene);
    const double shadowed = Brightness(scene.Render());
    check.AtLeast(name + ": light that arrives", shadowed, 1.0);
    scene.Property->ShadowsOff();
    check.AtMost(name + " with shadows", shadowed, 0.9 * Brightness(scene.Render()));
  }
}

void CheckLinks(Check& check)
{
  ShadowScene scene;
  vtkLight* sun = scene.AddSun(1.0, 0.0, 1.0);
  scene.Render();
  scene.Property->SetShadowAngle(
    1.0); // VTK's property has a gradient opacity once its mapper has asked for one
  scene.Render();
  const int links = scene.Optics->GetProgramLinkCount();
  const auto draw = [&](const std::string& name) {
    std::vector<unsigned char> pixels = scene.Render();
    check.That(scene.Optics->GetProgramLinkCount() == links, name + " links a program");
    return pixels;
  };
  scene.Property->SetShadowAngle(10.0);
  const std::vector<unsigned char> narrow = draw("a first angle");
  scene.Property->SetShadowAngle(30.0);
  check.That(draw("another angle") != narrow, "the angle changes nothing");
  sun->SetPosition(-1.0, 0.0, 1.0);
  draw("a moved light");
  sun->SetShadowAttenuation(0.5F);
  draw("a light's shadow attenuation");
  scene.Renderer->GetActiveCamera()->Azimuth(20.0);
  draw("the camera");
}

// VTK 9.1 takes six of them, and says so.
void CheckManyLights(Check& check)
{
  ShadowScene scene;
  const Warnings warnings(scene.Optics);
  double alone = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 0.8 * i;
    vtkLight* light = scene.AddLight(2.0 * std::cos(angle), 2.0 * std::sin(angle), 2.0, i % 2 == 0);
    light->SetIntensity(0.1);
    alone = i == 0 ? Brightness(scene.Render()) : alone;
  }
  check.AtLeast("eight lights", Brightness(scene.Render()), 4.0 * alone);
  check.That(
    scene.Optics->GetActiveTerms() == "Reflectance,Shadows", "eight: " + scene.Optics->GetActiveTerms());
  check.AtMost("messages of eight lights", static_cast<double>(warnings.Texts.size()), 1.0);
  scene.Optics->RemoveObserver(warnings.Command);
}

// What a clipping plane takes away casts no shadow: the floor without the ball is as bright as one alone.
void CheckClipping(Check& check)
{
  ShadowScene scene;
  scene.AddSun(0.0, 0.0, 1.0);
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, -0.1, 6.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, -0.3);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene.Mapper->AddClippingPlane(plane);
  const std::vector<unsigned char> clipped = scene.Render();
  const std::size_t middle = 3 * (30 * 60 + 30), side = 3 * (30 * 60 + 22);
  check.AtLeast("the floor", clipped[side], 60.0);
  check.Near("the floor below a ball that is cut away", clipped[middle], clipped[side], 3.0);
}

std::vector<unsigned char> DrawScaled(double scale, bool positional)
{
  ShadowScene scene;
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, i, scale);
  }
  scene.Volume->SetUserMatrix(matrix);
  scene.AddLight(scale, 0.5 * scale, 2.0 * scale, positional);
  scene.Property->SetShadowAngle(5.0);
  scene.Renderer->GetActiveCamera()->SetPosition(0.5 * scale, -3.5 * scale, 2.5 * scale);
  scene.Renderer->ResetCameraClippingRange();
  return scene.Render();
}

void CheckScales(Check& check)
{
  for (const bool positional : { false, true })
  {
    const std::vector<unsigned char> expected = DrawScaled(1.0, positional);
    check.AtLeast("brightness", Brightness(expected), 5.0);
    for (const double scale : { 1.0e-6, 1.0e6 })
    {
      // matrices in float
      check.AtMost("scale " + std::to_string(scale) + (positional ? ", lamp" : ", sun"),
        LargestDifference(expected, DrawScaled(scale, positional)), 2.0);
    }
  }
}

// A plate in the light of the volume's right half, out of the picture.
void CheckGeometry(Check& check)
{
  for (const bool positional : { false, true })
  {
    ShadowScene scene;
    scene.Property->SetShadowAngle(2.0);
    scene.AddLight(0.0, 0.0, 5.0, positional);
    scene.Renderer->GetActiveCamera()->SetPosition(0.0, -6.0, 2.0);
    const std::vector<unsigned char> lit = scene.Render();
    vtkNew<vtkPlaneSource> plate;
    plate->SetOrigin(0.0, -1.5, 2.0);
    plate->SetPoint1(1.5, -1.5, 2.0);
    plate->SetPoint2(0.0, 1.5, 2.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plate->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
    const std::vector<unsigned char> shadowed = scene.Render();
    const std::string name = positional ? "lamp, " : "sun, ";
    const std::size_t left = 3 * (16 * 60 + 22), right = 3 * (16 * 60 + 38);
    check.AtLeast(name + "the floor", lit[left], 40.0);
    check.Near(name + "beside the plate", shadowed[left], lit[left], 2.0);
    check.AtLeast(name + "the floor on the right", lit[right], 40.0);
    check.AtMost(name + "below the plate", shadowed[right], 1.0);
    actor->VisibilityOff();
    check.That(scene.Render() == lit, name + "the plate casts a shadow when it is not visible");
  }
}
}

int TestShadows(int, char*[])
{
  Check check;
  CheckOff(check);
  CheckModels(check);
  CheckEvaluations(check);
  CheckLinks(check);
  CheckManyLights(check);
  CheckClipping(check);
  CheckScales(check);
  CheckGeometry(check);
  return check.ExitCode();
}
