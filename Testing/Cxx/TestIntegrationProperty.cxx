// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The settings of the integral at the property: defaults, choices, the list of isosurfaces, the unit of data;
// what is refused is said in one warning.

#include "TestScene.h"

#include <functional>
#include <limits>
#include <sstream>

namespace
{
using Property = vtkOpticsVolumeProperty;
using Change = std::function<void(Property*)>;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

// One warning with the part in it.
void CheckSaidOnce(
  Check& check, const std::string& name, Property* property, const std::string& part, const Change& change)
{
  const Warnings warnings(property);
  const std::size_t before = warnings.Texts.size();
  change(property);
  const std::size_t count = warnings.Texts.size() - before;
  check.That(count == 1, name + ": said " + std::to_string(count) + " times, not once");
  check.That(
    count > 0 && warnings.Texts.back().find(part) != std::string::npos, name + ": " + part + " is not told");
  property->RemoveObserver(warnings.Command);
}

void CheckUnchanged(Check& check, const std::string& name, const std::string& part, const Change& change)
{
  vtkNew<Property> property;
  const vtkMTimeType before = property->GetMTime();
  CheckSaidOnce(check, name, property, part, change);
  check.That(property->GetMTime() == before, name + ": the property is modified");
}

// A setting of a few values with names.
struct Choice
{
  const char* Name;
  void (Property::*Set)(int);
  int (Property::*Get)();
  const char* (Property::*GetAsString)();
  std::vector<const char*> Names;
  std::vector<void (Property::*)()> SetTo;
};

const Choice Choices[] = {
  { "IntegrationSpace", &Property::SetIntegrationSpace, &Property::GetIntegrationSpace,
    &Property::GetIntegrationSpaceAsString, { "Physical", "Data" },
    { &Property::SetIntegrationSpaceToPhysical, &Property::SetIntegrationSpaceToData } },
  { "Classification", &Property::SetClassification, &Property::GetClassification,
    &Property::GetClassificationAsString, { "Post", "PreIntegrated" },
    { &Property::SetClassificationToPost, &Property::SetClassificationToPreIntegrated } },
  { "Silhouette", &Property::SetSilhouette, &Property::GetSilhouette, &Property::GetSilhouetteAsString,
    { "Off", "Exact", "Clamped", "Gradient" },
    { &Property::SetSilhouetteToOff, &Property::SetSilhouetteToExact, &Property::SetSilhouetteToClamped,
      &Property::SetSilhouetteToGradient } },
  { "TransmittedLight", &Property::SetTransmittedLight, &Property::GetTransmittedLight,
    &Property::GetTransmittedLightAsString, { "Off", "Diffuse", "DiffuseAndSpecular" },
    { &Property::SetTransmittedLightToOff, &Property::SetTransmittedLightToDiffuse,
      &Property::SetTransmittedLightToDiffuseAndSpecular } },
};

void CheckChoice(Check& check, const Choice& choice)
{
  vtkNew<Property> property;
  const std::string name = choice.Name;
  const int count = static_cast<int>(choice.Names.size());
  check.That((property->*choice.Get)() == 0, name + ": the default is not the first");
  for (int i = count - 1; i >= 0; --i)
  {
    const vtkMTimeType before = property->GetMTime();
    (property->*choice.SetTo[i])();
    check.That((property->*choice.Get)() == i, name + ": " + choice.Names[i] + " is not set");
    check.That(std::string((property->*choice.GetAsString)()) == choice.Names[i], name + ": wrong name");
    const vtkMTimeType changed = property->GetMTime();
    check.That(changed > before, name + ": a change does not modify the property");
    (property->*choice.Set)(i);
    check.That(property->GetMTime() == changed, name + ": the same value modifies the property");
  }
  for (const int wrong : { -1, count })
  {
    CheckUnchanged(
      check, name, name + " " + std::to_string(wrong), [&](Property* p) { (p->*choice.Set)(wrong); });
  }
}

void CheckUnitInterval(Check& check)
{
  vtkNew<Property> property;
  check.Near("default unit interval", property->GetScalarOpacityUnitInterval(), 0.0, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-10.0, 0.0);
  opacity->AddPoint(40.0, 1.0);
  property->SetScalarOpacity(opacity);
  check.Near(
    "a hundredth of the function's range", property->GetEffectiveScalarOpacityUnitInterval(), 0.5, 0.0);
  property->SetScalarOpacityUnitInterval(3.0);
  check.Near("a given interval", property->GetEffectiveScalarOpacityUnitInterval(), 3.0, 0.0);
  for (const double wrong : { -2.0, -Infinity })
  {
    property->SetScalarOpacityUnitInterval(3.0);
    CheckSaidOnce(check, "negative interval", property, "[0, ",
      [wrong](Property* p) { p->SetScalarOpacityUnitInterval(wrong); });
    check.Near("negative interval", property->GetScalarOpacityUnitInterval(), 0.0, 0.0);
  }
  CheckUnchanged(check, "interval that is no number", "not a number",
    [](Property* p) { p->SetScalarOpacityUnitInterval(NotANumber); });
  opacity->RemoveAllPoints();
  opacity->AddPoint(5.0, 0.5);
  check.Near("a function of one node", property->GetEffectiveScalarOpacityUnitInterval(), 0.0, 0.0);
}

void CheckSurface(
  Check& check, const std::string& name, Property* property, int index, const std::vector<double>& expected)
{
  check.Near(name + ": value", property->GetIsosurfaceValue(index), expected[0], 0.0);
  check.Near(name + ": opacity", property->GetIsosurfaceOpacity(index), expected[1], 0.0);
  check.That(property->GetIsosurfaceHasColor(index) == (expected.size() > 2), name + ": colour of its own");
  double rgb[3];
  property->GetIsosurfaceColor(index, rgb);
  for (std::size_t c = 2; c < expected.size(); ++c)
  {
    check.Near(name + ": colour", rgb[c - 2], expected[c], 0.0);
  }
}

void CheckIsosurfaces(Check& check)
{
  vtkNew<Property> property;
  check.That(property->GetNumberOfIsosurfaces() == 0, "there are isosurfaces by default");
  check.That(property->AddIsosurface(7.0, 0.1, 0.2, 0.3, 0.4) == 0, "index of the first isosurface");
  check.That(property->AddIsosurface(-2.0, 1.0) == 1, "index of the second isosurface");
  check.That(property->AddIsosurface(3.0, 0.5, 0.6, 0.7, 0.0) == 2, "index of the third isosurface");
  CheckSurface(check, "first", property, 0, { 7.0, 0.4, 0.1, 0.2, 0.3 });
  CheckSurface(check, "second", property, 1, { -2.0, 1.0 });
  CheckSurface(check, "third", property, 2, { 3.0, 0.0, 0.5, 0.6, 0.7 });

  vtkMTimeType before = property->GetMTime();
  property->RemoveIsosurface(0);
  check.That(property->GetMTime() > before, "a removed isosurface does not modify the property");
  check.That(property->GetNumberOfIsosurfaces() == 2, "number after one is removed");
  CheckSurface(check, "second, now first", property, 0, { -2.0, 1.0 });
  property->RemoveAllIsosurfaces();
  check.That(property->GetNumberOfIsosurfaces() == 0, "number after all are removed");
  before = property->GetMTime();
  property->RemoveAllIsosurfaces();
  check.That(property->GetMTime() == before, "removing none modifies the property");
  property->AddIsosurface(1.0, 1.0);
  check.That(property->GetMTime() > before, "an added isosurface does not modify the property");
}

void CheckRefusedIsosurfaces(Check& check)
{
  for (const double value : { NotANumber, Infinity, -Infinity })
  {
    CheckUnchanged(check, "value that is not finite", "is not added", [&check, value](Property* p) {
      check.That(p->AddIsosurface(value, 0.5) == -1, "a value that is not finite is added");
    });
  }
  for (const int index : { -1, 0, 1000 })
  {
    const std::string told = "no isosurface " + std::to_string(index);
    CheckUnchanged(check, "removed", told, [index](Property* p) { p->RemoveIsosurface(index); });
    CheckUnchanged(
      check, "value", told, [&](Property* p) { check.Near(told, p->GetIsosurfaceValue(index), 0.0, 0.0); });
    CheckUnchanged(check, "opacity", told,
      [&](Property* p) { check.Near(told, p->GetIsosurfaceOpacity(index), 0.0, 0.0); });
    CheckUnchanged(check, "whether coloured", told,
      [&](Property* p) { check.That(!p->GetIsosurfaceHasColor(index), told); });
    CheckUnchanged(check, "colour", told, [index](Property* p) {
      double rgb[3] = {};
      p->GetIsosurfaceColor(index, rgb);
    });
  }
}

// Opacity and each of the colours is bounded, with one warning, and the surface is added.
void CheckBounded(Check& check)
{
  for (int place = 0; place < 4; ++place)
  {
    const char* const names[] = { "Red", "Green", "Blue", "Opacity" };
    for (const double wrong : { -0.5, 1.5, Infinity, NotANumber })
    {
      double rgba[4] = { 0.25, 0.25, 0.25, 0.25 };
      rgba[place] = wrong;
      vtkNew<Property> property;
      const std::string name = std::string(names[place]) + " of an isosurface";
      CheckSaidOnce(check, name, property, name,
        [&rgba](Property* p) { p->AddIsosurface(1.0, rgba[0], rgba[1], rgba[2], rgba[3]); });
      rgba[place] = wrong > 1.0 ? 1.0 : 0.0;
      CheckSurface(check, name, property, 0, { 1.0, rgba[3], rgba[0], rgba[1], rgba[2] });
    }
  }
  vtkNew<Property> property;
  CheckSaidOnce(check, "colourless", property, "[0, 1]", [](Property* p) { p->AddIsosurface(1.0, 2.0); });
  CheckSurface(check, "colourless", property, 0, { 1.0, 1.0 });
}

std::string TextOf(Property* property)
{
  std::ostringstream text;
  property->PrintSelf(text, vtkIndent());
  return text.str().substr(std::min(text.str().find("IntegrationSpace:"), text.str().size()));
}

void CheckCopies(Check& check)
{
  vtkNew<Property> source;
  source->SetIntegrationSpaceToData();
  source->SetClassificationToPreIntegrated();
  source->SetScalarOpacityUnitInterval(0.125);
  source->SetSilhouetteToClamped();
  source->SetTransmittedLightToDiffuse();
  source->AddIsosurface(7.0, 0.1, 0.2, 0.3, 0.4);
  source->AddIsosurface(-2.0, 0.9);
  for (const char* told : { "IntegrationSpace: Data", "Classification: PreIntegrated",
         "ScalarOpacityUnitInterval: 0.125", "Silhouette: Clamped", "TransmittedLight: Diffuse",
         "value 7, opacity 0.4, colour (0.1, 0.2, 0.3)", "value -2, opacity 0.9, colour of the data" })
  {
    check.That(TextOf(source).find(told) != std::string::npos, std::string(told) + " is not printed");
  }
  vtkNew<Property> copy;
  copy->AddIsosurface(99.0, 1.0);
  copy->DeepCopy(source);
  check.That(TextOf(copy) == TextOf(source), "a copy has other settings");
  check.That(copy->GetNumberOfIsosurfaces() == 2, "a copy has other isosurfaces");
  CheckSurface(check, "copied", copy, 0, { 7.0, 0.4, 0.1, 0.2, 0.3 });
  CheckSurface(check, "copied", copy, 1, { -2.0, 0.9 });
  source->RemoveAllIsosurfaces();
  check.That(copy->GetNumberOfIsosurfaces() == 2, "a copy loses isosurfaces with its source");
}
}

int TestIntegrationProperty(int, char*[])
{
  Check check;
  for (const Choice& choice : Choices)
  {
    CheckChoice(check, choice);
  }
  CheckUnitInterval(check);
  CheckIsosurfaces(check);
  CheckRefusedIsosurfaces(check);
  CheckBounded(check);
  CheckCopies(check);
  return check.ExitCode();
}
