// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsPreset.h"

#include "JsonDocument.h"

#include "vtkObjectFactory.h"
#include "vtkOpticsVolumeProperty.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkOpticsPreset);

namespace
{
using Property = vtkOpticsVolumeProperty;

struct Setting
{
  const char* Name;
  const char* Valid;
  bool (*Set)(Property* property, const Json::Value& value);
};

bool SetReflectanceModel(Property* property, const Json::Value& value)
{
  const int current = property->GetReflectanceModel();
  for (int model = 0; value.isString() && model < Property::NumberOfReflectanceModels; ++model)
  {
    property->SetReflectanceModel(model);
    if (value.asString() == property->GetReflectanceModelAsString())
    {
      return true;
    }
  }
  property->SetReflectanceModel(current);
  return false;
}

bool SetFrameSource(Property* property, const Json::Value& value)
{
  const std::string name = value.isString() ? value.asString() : "";
  if (name != "Covariance" && name != "Curvature")
  {
    return false;
  }
  property->SetFrameSource(name == "Curvature" ? Property::Curvature : Property::Covariance);
  return true;
}

bool SetGlossiness(Property* property, const Json::Value& value)
{
  const bool valid = value.isNumeric() && property->GetGlossiness() > 0.0;
  if (valid)
  {
    property->SetGlossiness(value.asDouble());
  }
  return valid;
}

bool SetAnisotropyScale(Property* property, const Json::Value& value)
{
  const int model = property->GetReflectanceModel();
  const bool valid = value.isNumeric() && (model == Property::Ward || model == Property::Lafortune);
  if (valid)
  {
    property->SetAnisotropyScale(value.asDouble());
  }
  return valid;
}

bool SetScatteringAnisotropy(Property* property, const Json::Value& value)
{
  if (value.isNumeric())
  {
    property->SetScatteringAnisotropy(value.asFloat());
  }
  return value.isNumeric();
}

bool SetSpecularFromExtinction(Property* property, const Json::Value& value)
{
  if (value.isBool())
  {
    property->SetSpecularFromExtinction(value.asBool());
  }
  return value.isBool();
}

// In the order in which they are set: what depends on the model comes after it.
const Setting Settings[] = {
  { "ReflectanceModel", "\"VTK\", \"None\", \"BlinnPhong\", \"Ward\" or \"Lafortune\"", SetReflectanceModel },
  { "Glossiness", "a number, with ReflectanceModel BlinnPhong, Ward or Lafortune", SetGlossiness },
  { "AnisotropyScale", "a number, with ReflectanceModel Ward or Lafortune", SetAnisotropyScale },
  { "ScatteringAnisotropy", "a number in [-1, 1]", SetScatteringAnisotropy },
  { "SpecularFromExtinction", "true or false", SetSpecularFromExtinction },
  { "FrameSource", "\"Covariance\" or \"Curvature\"", SetFrameSource },
};

std::string NamesOfSettings()
{
  std::string names;
  for (const Setting& setting : Settings)
  {
    names += names.empty() ? "" : ", ";
    names += setting.Name;
  }
  return names;
}

//------------------------------------------------------------------------------
bool ReadObject(const char* fileName, Json::Value& object)
{
  try
  {
    object = volumeoptics::ReadJsonObject(fileName);
  }
  catch (const volumeoptics::JsonError& error)
  {
    vtkGenericWarningMacro(<< "The preset " << (fileName ? fileName : "(no name)") << ": " << error.what()
                           << " VTK's own model is used.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void WarnOfUnknownKeys(const char* fileName, const Json::Value& object)
{
  for (const std::string& key : object.getMemberNames())
  {
    const bool known = std::any_of(
      std::begin(Settings), std::end(Settings), [&](const Setting& setting) { return key == setting.Name; });
    if (!known)
    {
      vtkGenericWarningMacro(<< "The preset " << fileName << " has the unknown key \"" << key
                             << "\"; the keys are " << NamesOfSettings() << ".");
    }
  }
}
}

//------------------------------------------------------------------------------
bool vtkOpticsPreset::Read(const char* fileName, vtkOpticsVolumeProperty* property)
{
  Json::Value object;
  if (!property || !ReadObject(fileName, object))
  {
    return false;
  }
  WarnOfUnknownKeys(fileName, object);
  for (const Setting& setting : Settings)
  {
    if (object.isMember(setting.Name) && !setting.Set(property, object[setting.Name]))
    {
      vtkGenericWarningMacro(<< "The preset " << fileName << " has a value of \"" << setting.Name
                             << "\" that is not valid; valid is " << setting.Valid << ".");
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkOpticsPreset::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
