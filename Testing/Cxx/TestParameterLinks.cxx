// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every setting of the property and knob of the mapper, as PrintSelf() has them: whether changing it links a program,
// the ray's or the sweep's. What links none changes the picture, so that the setting is known to be in use.

#include "LineTermScene.h"
#include "SmallScene.h"

#include "vtkLight.h"
#include "vtkMultiSampleClassification.h"
#include "vtkVisibilitySweep.h"

#include <functional>
#include <set>
#include <sstream>

namespace
{
using Setting = std::function<void(TestScene&)>;

enum Effect
{
  Uniform,      // changes the picture, links nothing
  UniformAlike, // links nothing; the picture remains, or nearly
  Source        // links
};

struct Parameter
{
  const char* Name; // in PrintSelf()
  Effect Is;
  Setting Use; // what it is a setting of
  Setting Change;
};

void UseWard(TestScene& s)
{
  s.Property->SetReflectanceModelToWard();
}
void UseData(TestScene& s)
{
  s.Property->SetIntegrationSpaceToData();
}
void UseLight(TestScene& s)
{
  const double low[2] = { -1.0, 0.45 }, high[2] = { 0.5, 2.0 };
  vtkNew<vtkLightingTransferFunction> function;
  function->AddBoundary(low, high, 0.2, 0.7, 0.2);
  s.Property->SetLightingTransferFunction(function);
}
void UseOcclusion(TestScene& s)
{
  s.Property->OcclusionOn();
  s.Property->SetAmbient(1.0);
  s.Optics->SetVisibilityGridSize(32);
}
void UseDisk(TestScene& s)
{
  UseOcclusion(s);
  s.Optics->SetVisibilityAlgorithmToDisk();
}
void UseShadows(TestScene& s)
{
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(3.0, -2.0, 4.0);
  s.Renderer->AddLight(sun);
  s.Property->ShadowsOn();
  s.Property->SetShadowAngle(5.0);
  s.Optics->SetVisibilityGridSize(32);
}
void UseGlossiness(TestScene& s, int model)
{
  s.Property->SetReflectanceModel(model);
  s.Property->SetSpecular(1.0);
}
void UseTable(TestScene& s)
{
  UseData(s);
  s.Property->SetClassificationToPreIntegrated();
}
void Nothing(TestScene&) {}

using P = vtkOpticsVolumeProperty;

const std::vector<Parameter> OfProperty = {
  { "ReflectanceModel", Source, UseWard, [](TestScene& s) { s.Property->SetReflectanceModelToLafortune(); } },
  { "Glossiness of BlinnPhong", Uniform, [](TestScene& s) { UseGlossiness(s, P::BlinnPhong); },
    [](TestScene& s) { s.Property->SetGlossiness(3.0); } },
  { "Glossiness of Ward", Uniform, [](TestScene& s) { UseGlossiness(s, P::Ward); },
    [](TestScene& s) { s.Property->SetGlossiness(0.05); } },
  { "Glossiness of Lafortune", Uniform, [](TestScene& s) { UseGlossiness(s, P::Lafortune); },
    [](TestScene& s) { s.Property->SetGlossiness(3.0); } },
  { "AnisotropyScale of BlinnPhong", UniformAlike, UseWard,
    [](TestScene& s) {
      s.Property->SetAnisotropyScale(P::Lafortune, 2.0);
    } }, // it has none; nor is the other's used
  { "AnisotropyScale of Ward", Uniform, [](TestScene& s) { UseGlossiness(s, P::Ward); },
    [](TestScene& s) { s.Property->SetAnisotropyScale(60.0); } },
  { "AnisotropyScale of Lafortune", Uniform, [](TestScene& s) { UseGlossiness(s, P::Lafortune); },
    [](TestScene& s) { s.Property->SetAnisotropyScale(60.0); } },
  { "SpecularFromExtinction", Uniform, UseWard,
    [](TestScene& s) { s.Property->SpecularFromExtinctionOff(); } },
  { "FrameSource", Uniform, UseWard, [](TestScene& s) { s.Property->SetFrameSourceToCurvature(); } },
  { "ScatteringAnisotropy", Uniform, UseWard,
    [](TestScene& s) { s.Property->SetScatteringAnisotropy(0.4F); } },
  { "IntegrationSpace", Source, Nothing, UseData },
  { "Classification", Source, UseData, [](TestScene& s) { s.Property->SetClassificationToPreIntegrated(); } },
  { "ScalarOpacityUnitInterval", Uniform, UseData,
    [](TestScene& s) { s.Property->SetScalarOpacityUnitInterval(0.3); } },
  { "Silhouette", Source, UseData,
    [](TestScene& s) {
      s.Property->SetScalarOpacityUnitInterval(0.3);
      s.Property->SetSilhouetteToExact();
    } },
  { "TransmittedLight", Source, UseData, [](TestScene& s) { s.Property->SetTransmittedLightToDiffuse(); } },
  { "LightingTransferFunction", Source, Nothing, UseLight },
  { "MultiSampleClassification", Source, Nothing,
    [](TestScene& s) {
      const double any[2] = { -1.0, 2.0 };
      vtkNew<vtkMultiSampleClassification> rules;
      rules->AddRule(any, any, any, 0.9, 0.2, 0.1, 0.3);
      s.Property->SetMultiSampleClassification(rules);
    } },
  { "GradientStepLength", Uniform, UseLight, [](TestScene& s) { s.Property->SetGradientStepLength(3.0); } },
  { "LightScale", Uniform, UseLight, [](TestScene& s) { s.Property->SetLightScale(0.5); } },
  { "HybridNormals", Source, UseLight, [](TestScene& s) { s.Property->HybridNormalsOn(); } },
  { "Occlusion", Source, Nothing, UseOcclusion },
  { "OcclusionAngle", Uniform, UseOcclusion, [](TestScene& s) { s.Property->SetOcclusionAngle(20.0); } },
  { "AmbientColor", Uniform, UseOcclusion, [](TestScene& s) { s.Property->SetAmbientColor(1.0, 0.2, 0.1); } },
  { "Shadows", Source, Nothing, UseShadows },
  { "ShadowAngle", Uniform, UseShadows, [](TestScene& s) { s.Property->SetShadowAngle(30.0); } },
};

const std::vector<Parameter> OfMapper = {
  { "Optics", UniformAlike, UseWard, [](TestScene& s) { s.Optics->SetOptics(s.Property); } },
  { "FrameResolutionFactor", Uniform, UseWard,
    [](TestScene& s) { s.Optics->SetFrameResolutionFactor(0.25); } },
  { "FramePrecision", UniformAlike, UseWard, [](TestScene& s) { s.Optics->SetFramePrecision(32); } },
  { "ExtinctionGradient", Source, UseWard,
    [](TestScene& s) { s.Optics->SetExtinctionGradientToCentralDifferences(); } },
  { "ScalarGradient", Source, UseLight,
    [](TestScene& s) { s.Optics->SetScalarGradientToCentralDifferences(); } },
  { "LightingTableSize", Uniform, UseLight, [](TestScene& s) { s.Optics->SetLightingTableSize(4); } },
  { "LightingSamples", Source, UseLight, [](TestScene& s) { s.Optics->SetLightingSamplesToExtrapolated(); } },
  { "PreIntegrationTableSize", Uniform, UseTable,
    [](TestScene& s) { s.Optics->SetPreIntegrationTableSize(4); } },
  { "VisibilityGridSize", Uniform, UseOcclusion, [](TestScene& s) { s.Optics->SetVisibilityGridSize(8); } },
  { "VisibilitySliceDistance", Uniform, UseOcclusion,
    [](TestScene& s) { s.Optics->SetVisibilitySliceDistance(4.0); } },
  { "VisibilitySamples", Source, UseOcclusion, [](TestScene& s) { s.Optics->SetVisibilitySamples(4); } },
  { "VisibilityGatherSamples", Source, UseOcclusion,
    [](TestScene& s) { s.Optics->SetVisibilityGatherSamples(2); } },
  { "VisibilityAlgorithm", Source, UseOcclusion,
    [](TestScene& s) { s.Optics->SetVisibilityAlgorithmToDisk(); } },
  { "VisibilityDiskSize", Uniform, UseDisk, [](TestScene& s) { s.Optics->SetVisibilityDiskSize(1); } },
  { "VisibilityTrueDistances", Uniform, UseDisk,
    [](TestScene& s) { s.Optics->VisibilityTrueDistancesOff(); } },
  { "VisibilityPrecision", UniformAlike, UseOcclusion,
    [](TestScene& s) { s.Optics->SetVisibilityPrecision(32); } },
  { "TablePrecision", UniformAlike, UseTable, [](TestScene& s) { s.Optics->SetTablePrecision(16); } },
  { "SkipEmptySpace", Source, UseWard, [](TestScene& s) { s.Optics->SkipEmptySpaceOn(); } },
  { "MacrocellSize", UniformAlike,
    [](TestScene& s) {
      UseWard(s);
      s.Optics->SkipEmptySpaceOn();
    },
    [](TestScene& s) { s.Optics->SetMacrocellSize(4); } },
  { "DrawnExtent", Source, UseWard, [](TestScene& s) { s.Optics->SetDrawnExtent(4, 20, 0, 31, 0, 31); } },
  { "WholeExtent", Source, UseWard, [](TestScene& s) { s.Optics->SetWholeExtent(-8, 40, 0, 31, 0, 31); } },
  { "Quality", Uniform, UseWard, [](TestScene& s) { s.Optics->SetQualityToDraft(); } },
};

struct LineParameter
{
  const char* Name;
  std::function<void(vtkOpticsVolumeMapper*)> Change;
};

// Of lines nothing links.
const std::vector<LineParameter> OfLines = {
  { "LinePrecision", [](vtkOpticsVolumeMapper* m) { m->SetLinePrecision(32); } },
  { "LineOpacityFunction",
    [](vtkOpticsVolumeMapper* m) {
      vtkNew<vtkPiecewiseFunction> function;
      function->AddPoint(0.0, 0.5);
      function->AddPoint(1.0, 1.0);
      m->SetLineOpacityFunction(function);
    } },
  { "LineRadiusScale of type 0", [](vtkOpticsVolumeMapper* m) { m->SetLineRadiusScale(0, 2.0); } },
  { "LineOpacityScale of type 0", [](vtkOpticsVolumeMapper* m) { m->SetLineOpacityScale(0, 0.5); } },
};

// What PrintSelf() tells, but is no setting.
const std::set<std::string> Told = { "ActiveTerms", "TermMemorySize", "ProgramLinkCount" };

// What is left of the names when those of the parent class are taken away.
std::set<std::string> PrintedNames(vtkObject* object, vtkObject* parent)
{
  std::set<std::string> names[2];
  for (int i = 0; i < 2; ++i)
  {
    std::stringstream text;
    (i == 0 ? object : parent)->Print(text);
    for (std::string line; std::getline(text, line);)
    {
      const std::size_t begin = line.find_first_not_of(' ');
      if (begin == 2) // deeper ones are other objects'
      {
        names[i].insert(line.substr(begin, line.find(':') - begin));
      }
    }
  }
  for (const std::string& name : names[1])
  {
    names[0].erase(name);
  }
  return names[0];
}

template <typename List>
void CheckListed(Check& check, std::set<std::string>& names, const List& list)
{
  for (const auto& parameter : list)
  {
    check.That(names.erase(parameter.Name) == 1, std::string(parameter.Name) + ": is not a setting");
  }
}

void CheckNoneIsLeft(Check& check, const std::set<std::string>& names)
{
  for (const std::string& name : names)
  {
    check.That(Told.count(name) == 1, name + ": does it link a program? List it here");
  }
}

int LinksOf(TestScene& scene)
{
  return scene.Optics->GetProgramLinkCount() + scene.Optics->GetOcclusionSweep()->GetProgramLinkCount();
}

void CheckParameter(Check& check, const Parameter& parameter)
{
  SmallScene scene;
  parameter.Use(scene);
  scene.Render();
  const std::vector<unsigned char> before = scene.Render();
  const int links = LinksOf(scene);
  parameter.Change(scene);
  scene.Render();
  const std::vector<unsigned char> after = scene.Render();
  const int linked = LinksOf(scene) - links;
  const std::string name = parameter.Name;
  check.That((linked > 0) == (parameter.Is == Source), name + ": linked " + std::to_string(linked));
  check.That(parameter.Is != Uniform || LargestDifference(before, after) > 1, name + ": is not in use");
}

void CheckLines(Check& check)
{
  for (const LineParameter& parameter : OfLines)
  {
    LineTermScene scene(Spirals(8, 8, 8, 0, false, 100), 32);
    scene.Render();
    const std::vector<unsigned char> before = scene.Render();
    const int links = scene.Mapper->GetProgramLinkCount();
    parameter.Change(scene.Mapper);
    scene.Render();
    const std::string name = parameter.Name;
    check.That(name == "LinePrecision" || scene.Render() != before, name + ": is not in use");
    check.Near(name, scene.Mapper->GetProgramLinkCount() - links, 0.0, 0.0);
  }
}
}

int TestParameterLinks(int, char*[])
{
  Check check;
  const vtkNew<vtkOpticsVolumeProperty> property;
  const vtkNew<vtkVolumeProperty> plainProperty;
  std::set<std::string> names = PrintedNames(property, plainProperty);
  CheckListed(check, names, OfProperty);
  CheckNoneIsLeft(check, names);
  const vtkNew<vtkOpticsVolumeMapper> mapper;
  const vtkNew<vtkOpenGLGPUVolumeRayCastMapper> plainMapper;
  mapper->SetLineRadiusScale(0, 1.0);
  mapper->SetLineOpacityScale(0, 1.0);
  names = PrintedNames(mapper, plainMapper);
  CheckListed(check, names, OfMapper);
  CheckListed(check, names, OfLines);
  CheckNoneIsLeft(check, names);
  for (const std::vector<Parameter>* list : { &OfProperty, &OfMapper })
  {
    for (const Parameter& parameter : *list)
    {
      CheckParameter(check, parameter);
    }
  }
  CheckLines(check);
  return check.ExitCode();
}
