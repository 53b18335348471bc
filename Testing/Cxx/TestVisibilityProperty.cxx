// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Occlusion and shadows at the property: defaults, switches, ranges with one warning, copies, and no
// modification where nothing changes.

#include "TestScene.h"

#include <functional>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
using Property = vtkOpticsVolumeProperty;
using Change = std::function<void(Property*)>;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

void CheckDefaults(Check& check)
{
  vtkNew<Property> property;
  check.That(!property->GetOcclusion() && !property->GetShadows(), "occlusion or shadows are on by default");
  check.Near("default angle of occlusion", property->GetOcclusionAngle(), 60.0, 0.0);
  check.Near("default angle of shadows", property->GetShadowAngle(), 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    check.Near("default ambient colour", property->GetAmbientColor()[i], 1.0, 0.0);
  }
}

struct Setting
{
  const char* Name;
  std::function<void(Property*, double)> Set;
  std::function<double(Property*)> Get;
  double Largest;
  const char* Range;
};

const Setting Settings[] = {
  { "OcclusionAngle", &Property::SetOcclusionAngle, &Property::GetOcclusionAngle, 80.0, "[0, 80]" },
  { "ShadowAngle", &Property::SetShadowAngle, &Property::GetShadowAngle, 80.0, "[0, 80]" },
  { "red", [](Property* p, double value) { p->SetAmbientColor(value, 1.0, 1.0); },
    [](Property* p) { return p->GetAmbientColor()[0]; }, 1.0, "[0, 1]" },
  { "green", [](Property* p, double value) { p->SetAmbientColor(1.0, value, 1.0); },
    [](Property* p) { return p->GetAmbientColor()[1]; }, 1.0, "[0, 1]" },
  { "blue", [](Property* p, double value) { p->SetAmbientColor(1.0, 1.0, value); },
    [](Property* p) { return p->GetAmbientColor()[2]; }, 1.0, "[0, 1]" },
};

void CheckSet(Check& check, const Setting& setting, double value, double expected, std::size_t messages)
{
  vtkNew<Property> property;
  setting.Set(property, 0.5);
  const Warnings warnings(property);
  setting.Set(property, value);
  std::ostringstream name;
  name << setting.Name << " of " << value;
  check.Near(name.str(), setting.Get(property), expected, 0.0);
  check.That(warnings.Texts.size() == messages,
    name.str() + ": " + std::to_string(warnings.Texts.size()) + " warnings, not " + std::to_string(messages));
  for (const std::string& text : warnings.Texts)
  {
    check.That(text.find(setting.Name) != std::string::npos && text.find(setting.Range) != std::string::npos,
      name.str() + ": its name or range is not told: " + text);
  }
  property->RemoveObserver(warnings.Command);
}

void CheckRanges(Check& check)
{
  for (const Setting& setting : Settings)
  {
    CheckSet(check, setting, 0.0, 0.0, 0);
    CheckSet(check, setting, setting.Largest, setting.Largest, 0);
    CheckSet(check, setting, std::nextafter(setting.Largest, Infinity), setting.Largest, 1);
    CheckSet(check, setting, Infinity, setting.Largest, 1);
    CheckSet(check, setting, -1.0e-300, 0.0, 1);
    CheckSet(check, setting, -Infinity, 0.0, 1);
    CheckSet(check, setting, NotANumber, 0.5, 1);
  }
}

const Change Changes[] = { [](Property* p) { p->OcclusionOn(); },
  [](Property* p) { p->SetOcclusionAngle(45.0); },
  [](Property* p) {
    const double rgb[3] = { 0.25, 0.5, 0.75 };
    p->SetAmbientColor(rgb);
  },
  [](Property* p) { p->ShadowsOn(); }, [](Property* p) { p->SetShadowAngle(2.5); } };

void CheckModified(Check& check)
{
  int number = 0;
  for (const Change& change : Changes)
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

std::string OwnText(Property* property)
{
  std::ostringstream text;
  property->PrintSelf(text, vtkIndent());
  const std::size_t begin = text.str().find("Occlusion:");
  return begin == std::string::npos ? std::string() : text.str().substr(begin);
}

void CheckCopies(Check& check)
{
  for (const Change& change : Changes)
  {
    vtkNew<Property> source, copy;
    change(source);
    check.That(OwnText(copy) != OwnText(source), "a change is not printed: " + OwnText(source));
    copy->DeepCopy(source);
    check.That(OwnText(copy) == OwnText(source), "a copy has other settings than " + OwnText(source));
  }
  vtkNew<Property> source;
  for (const Change& change : Changes)
  {
    change(source);
  }
  check.That(source->GetOcclusion() && source->GetShadows(), "a switch is not on");
  check.That(source->GetAmbientColor()[0] == 0.25 && source->GetAmbientColor()[2] == 0.75, "ambient colour");
  source->OcclusionOff();
  source->ShadowsOff();
  check.That(!source->GetOcclusion() && !source->GetShadows(), "a switch is not off");
}
}

int TestVisibilityProperty(int, char*[])
{
  Check check;
  CheckDefaults(check);
  CheckRanges(check);
  CheckModified(check);
  CheckCopies(check);
  return check.ExitCode();
}
