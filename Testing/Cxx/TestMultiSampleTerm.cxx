// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A classification by several samples in the ray caster, against VTK's pictures with transfer functions
// that say the same; what it refuses; and that editing rules links no program.

#include "ReferencePictures.h"
#include "ShaderText.h"
#include "SmallScene.h"
#include "SupportedSettings.h"
#include "TestScene.h"
#include "vtkMultiSampleClassification.h"

#include <cstdlib>
#include <fstream>
#include <functional>

namespace
{
const double Any[2] = { -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };

vtkSmartPointer<vtkMultiSampleClassification> Classify(TestScene& scene)
{
  auto rules = vtkSmartPointer<vtkMultiSampleClassification>::New();
  scene.Property->SetMultiSampleClassification(rules);
  return rules;
}

// VTK's own picture with these transfer functions.
std::vector<unsigned char> DrawStock(const std::function<void(TestScene&)>& setting)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  SmallScene scene(stock);
  setting(scene);
  return scene.Render();
}

void CheckSame(Check& check, const std::string& name, const std::vector<unsigned char>& expected,
  TestScene& scene, int bound)
{
  const int difference = LargestDifference(expected, scene.Render());
  check.That(difference <= bound, name + ": differs by " + std::to_string(difference));
  check.That(scene.Optics->GetActiveTerms() == "MultiSampleClassification", name + ": not active");
}

void CheckRules(Check& check, bool shade)
{
  const std::string name = shade ? "shaded" : "not shaded";
  const auto apply = [shade](TestScene& scene) { scene.Property->SetShade(shade); };
  SmallScene none;
  apply(none);
  Classify(none);
  CheckSame(check, name + ", no rule", DrawStock(apply), none, 0);

  SmallScene one;
  apply(one);
  Classify(one)->AddRule(Any, Any, Any, 0.9, 0.2, 0.1, 0.02);
  const auto constant = DrawStock([&](TestScene& scene) {
    apply(scene);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.0, 0.02);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.0, 0.9, 0.2, 0.1);
  });
  CheckSame(check, name + ", one rule for all", constant, one, 1);

  // a ramp in both; halfway opacities of a step are mixed here and those of a unit there, 1% apart
  SmallScene range;
  apply(range);
  range.Opacity->RemoveAllPoints();
  range.Opacity->AddPoint(0.0, 0.0);
  const double high[2] = { 0.5, 2.0 };
  const auto rules = Classify(range);
  rules->SetSoftness(
    rules->AddRule(high, Any, Any, 0.9, 0.2, 0.1, 0.05), vtkMultiSampleClassification::Center, 0.3);
  const auto ramp = DrawStock([&](TestScene& scene) {
    apply(scene);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.2, 0.0);
    scene.Opacity->AddPoint(0.5, 0.05);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.0, 0.9, 0.2, 0.1);
  });
  CheckSame(check, name + ", a rule for high scalars", ramp, range, 1);
}

// Two soft rules over the transfer functions, one that looks ahead and one that looks behind, in double.
void CheckReference(Check& check, int gradient)
{
  SmallScene scene;
  Frames frames(scene);
  scene.Property->ShadeOff();
  scene.Optics->SetScalarGradient(gradient);
  const auto rules = Classify(scene);
  const double low[2] = { 0.0, 0.3 }, middle[2] = { 0.3, 0.6 }, high[2] = { 0.55, 1.0 };
  rules->AddRule(middle, high, Any, 0.9, 0.2, 0.1, 0.2);
  rules->AddRule(Any, Any, low, 0.1, 0.8, 0.3, 0.02);
  for (int scalar = 0; scalar < 3; ++scalar)
  {
    rules->SetSoftness(0, scalar, 0.1);
    rules->SetSoftness(1, scalar, 0.2);
  }
  const reference::Difference difference =
    CompareShown(scene, Render(SceneOf(scene, frames)), FloatPicture(scene));
  std::cout << scene.Optics->GetScalarGradientAsString() << ": rms " << 255.0 * difference.rootMeanSquare
            << "/255, largest " << 255.0 * difference.maximum << "/255\n";
  reference::Scene without = SceneOf(scene, frames);
  without.rules = nullptr;
  check.AtLeast("rules in the picture",
    255.0 * CompareShown(scene, Render(without), FloatPicture(scene)).rootMeanSquare, 5.0);
  // as of the pictures without rules: VTK's steps and tables
  check.AtMost("rms against double", 255.0 * difference.rootMeanSquare, 0.1);
}

// Points near the surface have one side in the ball; with a rule for those that do not, it is hollow.
void CheckSides(Check& check, int samples)
{
  SmallScene scene;
  scene.Optics->SetLightingSamples(samples);
  scene.Property->ShadeOff();
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  const std::vector<unsigned char> empty = scene.Render();
  const auto rules = Classify(scene);
  const double low[2] = { 0.0, 0.5 }, high[2] = { 0.5, 1.0 };
  rules->AddRule(Any, high, low, 1.0, 1.0, 1.0, 0.5);
  check.That(LargestDifference(empty, scene.Render()) > 50, "a rule of both sides shows nothing");
  rules->SetRange(0, vtkMultiSampleClassification::Uphill, 0.0, 0.5);
  rules->SetRange(0, vtkMultiSampleClassification::Downhill, 0.5, 1.0);
  check.That(LargestDifference(empty, scene.Render()) == 0, "uphill and downhill are exchanged");
}

void CheckRefused(Check& check, const std::string& name, const std::function<void(TestScene&)>& setting)
{
  SmallScene expected, scene;
  setting(expected);
  setting(scene);
  Warnings warnings(scene.Optics);
  Classify(scene)->AddRule(Any, Any, Any, 0.9, 0.2, 0.1, 0.02);
  check.That(expected.Render() == scene.Render(), name + ": the classification changes the picture");
  scene.Render();
  check.That(warnings.Texts.size() == 1,
    name + ": said " + std::to_string(warnings.Texts.size()) + " times, not once");
}

void CheckLinks(Check& check)
{
  SmallScene scene;
  const auto rules = Classify(scene);
  rules->AddRule(Any, Any, Any, 0.9, 0.2, 0.1, 0.02);
  scene.Render();
  const int links = scene.Optics->GetProgramLinkCount();
  const std::vector<unsigned char> before = scene.Render();
  rules->SetColor(0, 0.1, 0.9, 0.1);
  check.That(LargestDifference(before, scene.Render()) > 10, "an edit of a rule is not drawn");
  while (rules->GetNumberOfRules() < vtkMultiSampleClassification::LargestNumberOfRules)
  {
    rules->AddRule(Any, Any, Any, 0.2, 0.2, 0.7, 1.0);
  }
  check.That(AreFinite(scene.RenderFloat()), "the largest number of rules: a pixel is not finite");
  check.That(scene.Optics->GetProgramLinkCount() == links, "an edit of the rules links a program");
}

void CheckText(Check& check)
{
  SmallScene scene;
  const ShaderText shader(scene.Mapper);
  Classify(scene)->AddRule(Any, Any, Any, 0.9, 0.2, 0.1, 0.02);
  scene.Render();
  scene.Render();
  const std::string path = std::string(VOLUMEOPTICS_TEMPORARY) + "/Optics-MultiSample.frag";
  std::ofstream(path) << shader.Text;
  const std::string command = std::string(VOLUMEOPTICS_GLSLANG) + " " + path;
  check.That(std::system(command.c_str()) == 0, path + " is not valid GLSL");
}
}

int TestMultiSampleTerm(int, char*[])
{
  Check check;
  CheckRules(check, false);
  CheckRules(check, true);
  CheckReference(check, vtkOpticsVolumeMapper::Automatic);
  CheckReference(check, vtkOpticsVolumeMapper::CentralDifferences);
  CheckSides(check, vtkOpticsVolumeMapper::Fetched);
  CheckSides(check, vtkOpticsVolumeMapper::Extrapolated);
  CheckLinks(check);
  CheckText(check);
  CheckRefused(check, "data space", [](TestScene& s) { s.Property->SetIntegrationSpaceToData(); });
  CheckRefused(
    check, "pre-integration", [](TestScene& s) { s.Property->SetClassificationToPreIntegrated(); });
  CheckRefused(check, "2D transfer function", Use2DFunction);
  CheckRefused(check, "Ward", [](TestScene& s) { s.Property->SetReflectanceModelToWard(); });
  CheckRefused(check, "maximum intensity", [](TestScene& s) { s.Mapper->SetBlendModeToMaximumIntensity(); });
  return check.ExitCode();
}
