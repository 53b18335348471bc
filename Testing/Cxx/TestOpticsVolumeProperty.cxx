// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The property: defaults, ranges with one warning that names value and range, values per model, names
// of choices, copies, and no modification where nothing changes.

#include "Check.h"
#include "vtkLightingTransferFunction.h"
#include "vtkMultiSampleClassification.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <functional>
#include <sstream>
#include <vector>

namespace
{
using Property = vtkOpticsVolumeProperty;
using Change = std::function<void(Property*)>;
using Value = std::function<double(Property*)>;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

// What a change says; nothing of it reaches the output.
std::vector<std::string> WarningsOf(Property* property, const Change& change)
{
  std::vector<std::string> texts;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&texts);
  command->SetCallback([](vtkObject*, unsigned long, void* client, void* text) {
    static_cast<std::vector<std::string>*>(client)->push_back(static_cast<const char*>(text));
  });
  const unsigned long warning = property->AddObserver(vtkCommand::WarningEvent, command);
  const unsigned long error = property->AddObserver(vtkCommand::ErrorEvent, command);
  change(property);
  property->RemoveObserver(warning);
  property->RemoveObserver(error);
  return texts;
}

void CheckDefaults(Check& check)
{
  vtkNew<Property> property;
  check.That(property->GetReflectanceModel() == Property::VTK, "the default model is not VTK's");
  check.That(property->GetFrameSource() == Property::Covariance, "the default source is not the covariance");
  check.That(property->GetSpecularFromExtinction(), "highlights are not from the extinction by default");
  check.Near("default anisotropy of scattering", property->GetScatteringAnisotropy(), 0.0, 0.0);
  check.Near("default exponent of Blinn-Phong", property->GetGlossiness(Property::BlinnPhong), 30.0, 0.0);
  check.Near("default roughness of Ward", property->GetGlossiness(Property::Ward), 0.2, 0.0);
  check.Near("default exponent of Lafortune", property->GetGlossiness(Property::Lafortune), 30.0, 0.0);
  check.Near("default scale of Ward", property->GetAnisotropyScale(Property::Ward), 10.0, 0.0);
  check.Near("default scale of Lafortune", property->GetAnisotropyScale(Property::Lafortune), 10.0, 0.0);
  check.Near("glossiness of VTK", property->GetGlossiness(), 0.0, 0.0);
  check.Near("anisotropy scale of Blinn-Phong", property->GetAnisotropyScale(Property::BlinnPhong), 0.0, 0.0);
  check.Near("glossiness of no model", property->GetGlossiness(17) + property->GetGlossiness(-1), 0.0, 0.0);

  vtkNew<vtkVolumeProperty> stock;
  check.That(property->GetShade() == stock->GetShade() && property->GetAmbient() == stock->GetAmbient() &&
      property->GetInterpolationType() == stock->GetInterpolationType(),
    "a default of VTK's differs from VTK's");
}

struct Setting
{
  const char* Name;
  std::function<void(Property*, double)> Set;
  Value Get;
  double Least, Largest;
  std::string Range; // as it is told
};

std::vector<Setting> Settings()
{
  std::vector<Setting> settings;
  const struct
  {
    int Model;
    const char* Name;
    double Least, Largest;
    const char* Range;
  } models[] = { { Property::BlinnPhong, "Glossiness of Blinn-Phong", 0.01, 1.0e5, "[0.01, 100000]" },
    { Property::Ward, "Glossiness of Ward", 1.0e-4, 1.0, "[0.0001, 1]" },
    { Property::Lafortune, "Glossiness of Lafortune", 0.01, 1.0e5, "[0.01, 100000]" } };
  for (const auto& row : models)
  {
    const int model = row.Model;
    settings.push_back({ row.Name, [model](Property* p, double v) { p->SetGlossiness(model, v); },
      [model](Property* p) { return p->GetGlossiness(model); }, row.Least, row.Largest, row.Range });
  }
  for (const int model : { Property::Ward, Property::Lafortune })
  {
    settings.push_back(
      { "AnisotropyScale", [model](Property* p, double v) { p->SetAnisotropyScale(model, v); },
        [model](Property* p) { return p->GetAnisotropyScale(model); }, 0.0, 1.0e4, "[0, 10000]" });
  }
  settings.push_back({ "ScatteringAnisotropy",
    [](Property* p, double v) { p->SetScatteringAnisotropy(static_cast<float>(v)); },
    [](Property* p) { return static_cast<double>(p->GetScatteringAnisotropy()); }, -1.0, 1.0, "[-1, 1]" });
  return settings;
}

// One warning with the value and the range; the nearest value is set, or, for none, the old one kept.
void CheckRefused(
  Check& check, const Setting& setting, double value, const std::string& told, double expected)
{
  vtkNew<Property> property;
  const double middle = 0.5 * (setting.Least + setting.Largest);
  setting.Set(property, middle);
  const std::vector<std::string> texts = WarningsOf(property, [&](Property* p) { setting.Set(p, value); });
  const std::string name = std::string(setting.Name) + " of " + told;
  check.That(texts.size() == 1, name + ": said " + std::to_string(texts.size()) + " times, not once");
  for (const std::string& text : texts)
  {
    check.That(text.find(told) != std::string::npos && text.find(setting.Range) != std::string::npos,
      name + ": value or range is not in " + text);
  }
  check.Near(name, setting.Get(property), std::isnan(value) ? middle : expected, 1.0e-7 * setting.Largest);
}

void CheckRanges(Check& check)
{
  for (const Setting& setting : Settings())
  {
    vtkNew<Property> property;
    for (const double value : { setting.Least, setting.Largest })
    {
      const auto texts = WarningsOf(property, [&](Property* p) { setting.Set(p, value); });
      check.That(texts.empty(), std::string(setting.Name) + ": an end of its range is refused");
      check.Near(setting.Name, setting.Get(property), value, 0.0);
    }
    CheckRefused(check, setting, -3.0, "-3", setting.Least);
    CheckRefused(check, setting, 2.0e5, "200000", setting.Largest);
    CheckRefused(check, setting, Infinity, "inf", setting.Largest);
    CheckRefused(check, setting, -Infinity, "-inf", setting.Least);
    CheckRefused(check, setting, NotANumber, "not a number", 0.0);
  }
}

void CheckSaidOnce(Check& check, const std::string& name, const std::string& part, const Change& change)
{
  vtkNew<Property> property;
  const vtkMTimeType before = property->GetMTime();
  const std::vector<std::string> texts = WarningsOf(property, change);
  check.That(
    texts.size() == 1 && texts[0].find(part) != std::string::npos, name + ": not said once with " + part);
  check.That(property->GetMTime() == before, name + ": the property is modified");
}

void CheckChoices(Check& check)
{
  CheckSaidOnce(check, "model 5", "Lafortune (4)", [](Property* p) { p->SetReflectanceModel(5); });
  CheckSaidOnce(check, "model -1", "-1", [](Property* p) { p->SetReflectanceModel(-1); });
  CheckSaidOnce(check, "source 2", "Curvature (1)", [](Property* p) { p->SetFrameSource(2); });
  CheckSaidOnce(check, "glossiness of VTK", "0.3", [](Property* p) { p->SetGlossiness(0.3); });
  CheckSaidOnce(check, "scale of Blinn-Phong", "40",
    [](Property* p) { p->SetAnisotropyScale(Property::BlinnPhong, 40.0); });

  vtkNew<Property> property;
  const char* const models[] = { "VTK", "None", "BlinnPhong", "Ward", "Lafortune" };
  for (int model = Property::VTK; model <= Property::Lafortune; ++model)
  {
    property->SetReflectanceModel(model);
    check.That(
      std::string(property->GetReflectanceModelAsString()) == models[model], "wrong name of a model");
  }
  property->SetFrameSourceToCurvature();
  check.That(std::string(property->GetFrameSourceAsString()) == "Curvature", "wrong name of the curvature");
  property->SetFrameSourceToCovariance();
  check.That(std::string(property->GetFrameSourceAsString()) == "Covariance", "wrong name of the covariance");
}

void CheckPerModel(Check& check)
{
  vtkNew<Property> property;
  property->SetReflectanceModelToBlinnPhong();
  property->SetGlossiness(80.0);
  property->SetReflectanceModelToWard();
  property->SetGlossiness(0.05);
  property->SetAnisotropyScale(3.0);
  property->SetReflectanceModelToLafortune();
  property->SetAnisotropyScale(60.0);
  check.Near("exponent of Lafortune", property->GetGlossiness(), 30.0, 0.0);
  check.Near("scale of Lafortune", property->GetAnisotropyScale(), 60.0, 0.0);
  property->SetReflectanceModelToWard();
  check.Near("roughness of Ward", property->GetGlossiness(), 0.05, 0.0);
  check.Near("scale of Ward", property->GetAnisotropyScale(), 3.0, 0.0);
  property->SetReflectanceModelToBlinnPhong();
  check.Near("exponent of Blinn-Phong", property->GetGlossiness(), 80.0, 0.0);
}

void SetAll(Property* property)
{
  property->SetReflectanceModelToLafortune();
  property->SetGlossiness(Property::BlinnPhong, 12.0);
  property->SetGlossiness(Property::Ward, 0.3);
  property->SetGlossiness(Property::Lafortune, 70.0);
  property->SetAnisotropyScale(Property::Ward, 4.0);
  property->SetAnisotropyScale(Property::Lafortune, 5.0);
  property->SpecularFromExtinctionOff();
  property->SetFrameSourceToCurvature();
  property->SetScatteringAnisotropy(0.4F);
}

// Everything of this class, in words.
std::string OwnText(Property* property)
{
  std::ostringstream text;
  property->PrintSelf(text, vtkIndent());
  const std::size_t begin = text.str().find("ReflectanceModel:");
  return begin == std::string::npos ? std::string() : text.str().substr(begin);
}

void CheckCopies(Check& check)
{
  vtkNew<Property> source;
  SetAll(source);
  source->ShadeOn();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(3.0, 0.25);
  source->SetScalarOpacity(opacity);

  vtkNew<Property> copy;
  check.That(OwnText(copy) != OwnText(source), "the settings are not printed");
  copy->DeepCopy(source);
  check.That(!OwnText(copy).empty() && OwnText(copy) == OwnText(source), "a copy has other settings");
  check.That(copy->GetShade() == 1, "a copy has not VTK's settings");
  check.That(copy->GetScalarOpacity() != opacity.Get(), "a copy shares the opacity function");
  check.Near("opacity of the copy", copy->GetScalarOpacity()->GetValue(3.0), 0.25, 0.0);
  const std::string before = OwnText(copy);
  source->SetGlossiness(31.0);
  check.That(OwnText(copy) == before, "a copy changes with its source");

  vtkNew<vtkVolumeProperty> plain;
  plain->SetSpecularPower(7.0);
  copy->DeepCopy(plain);
  check.That(OwnText(copy) == before, "a plain property takes settings away that it does not have");
  check.Near("specular power of the plain property", copy->GetSpecularPower(), 7.0, 0.0);
  check.That(copy->GetShade() == 0, "VTK's settings of the plain property are not copied");
}

void CheckModified(Check& check)
{
  const Change changes[] = { [](Property* p) { p->SetReflectanceModelToLafortune(); },
    [](Property* p) { p->SetGlossiness(Property::Ward, 0.3); },
    [](Property* p) { p->SetAnisotropyScale(Property::Ward, 4.0); },
    [](Property* p) { p->SpecularFromExtinctionOff(); }, [](Property* p) { p->SetFrameSourceToCurvature(); },
    [](Property* p) { p->SetScatteringAnisotropy(0.4F); } };
  int number = 0;
  for (const Change& change : changes)
  {
    vtkNew<Property> property;
    const std::string name = "change " + std::to_string(number++);
    const vtkMTimeType created = property->GetMTime();
    change(property);
    const vtkMTimeType changed = property->GetMTime();
    check.That(changed > created, name + " does not modify the property");
    change(property);
    check.That(property->GetMTime() == changed, name + " modifies the property the second time");
  }
}

// The functions that a property refers to: edited, they change it; copied, they are its own.
void CheckLighting(Check& check)
{
  vtkNew<Property> property;
  check.That(!property->GetLightingTransferFunction() && !property->GetMultiSampleClassification(),
    "there are functions by default");
  check.Near("default gradient step", property->GetGradientStepLength(), 1.0, 0.0);
  check.Near("default light scale", property->GetLightScale(), 1.0, 0.0);
  check.That(!property->GetHybridNormals(), "normals are hybrid by default");

  vtkNew<vtkLightingTransferFunction> function;
  vtkNew<vtkMultiSampleClassification> rules;
  property->SetLightingTransferFunction(function);
  property->SetMultiSampleClassification(rules);
  property->SetGradientStepLength(2.0);
  property->SetLightScale(5.0);
  property->HybridNormalsOn();
  const double a[2] = { 0.0, 1.0 }, b[2] = { 2.0, 3.0 };
  vtkMTimeType before = property->GetMTime();
  function->AddBoundary(a, b, 0.1, 0.2, 0.3);
  check.That(property->GetMTime() > before, "an edited boundary does not modify the property");
  before = property->GetMTime();
  rules->AddRule(a, a, b, 1.0, 1.0, 1.0, 1.0);
  check.That(property->GetMTime() > before, "an edited rule does not modify the property");
  before = property->GetMTime();
  property->SetLightingTransferFunction(function);
  property->SetLightScale(5.0);
  check.That(property->GetMTime() == before, "the same function modifies the property");

  vtkNew<Property> copy;
  copy->DeepCopy(property);
  check.Near("copied gradient step", copy->GetGradientStepLength(), 2.0, 0.0);
  check.Near("copied light scale", copy->GetLightScale(), 5.0, 0.0);
  check.That(copy->GetHybridNormals(), "hybrid normals are not copied");
  check.That(copy->GetMultiSampleClassification() == rules, "the classification is not shared");
  check.That(copy->GetLightingTransferFunction() && copy->GetLightingTransferFunction() != function &&
      copy->GetLightingTransferFunction()->GetNumberOfBoundaries() == 1,
    "the lighting transfer function is not copied");
}

void CheckLightingRanges(Check& check)
{
  vtkNew<Property> property;
  const auto refused = [&](const std::string& range, const Change& change) {
    const std::vector<std::string> texts = WarningsOf(property, change);
    check.That(texts.size() == 1 && texts[0].find(range) != std::string::npos, range + " is not told once");
  };
  refused("[0, 10000]", [](Property* p) { p->SetGradientStepLength(-1.0); });
  check.Near("least gradient step", property->GetGradientStepLength(), 0.0, 0.0);
  refused("[0, 10000]", [](Property* p) { p->SetGradientStepLength(Infinity); });
  check.Near("largest gradient step", property->GetGradientStepLength(), 1.0e4, 0.0);
  refused("[0, 1e+06]", [](Property* p) { p->SetLightScale(-1.0); });
  refused("[0, 1e+06]", [](Property* p) { p->SetLightScale(NotANumber); });
  check.Near("least light scale", property->GetLightScale(), 0.0, 0.0);
}
}

int TestOpticsVolumeProperty(int, char*[])
{
  Check check;
  CheckDefaults(check);
  CheckRanges(check);
  CheckChoices(check);
  CheckPerModel(check);
  CheckCopies(check);
  CheckModified(check);
  CheckLighting(check);
  CheckLightingRanges(check);
  return check.ExitCode();
}
