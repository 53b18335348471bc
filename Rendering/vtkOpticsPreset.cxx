// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsPreset.h"

#include "JsonDocument.h"

#include "vtkNew.h"
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

// The choice that the property itself calls by this name.
template <int NumberOfChoices, void (Property::*Set)(int), const char* (Property::*Name)()>
bool SetByName(Property* property, const Json::Value& value)
{
  const vtkNew<Property> trial;
  for (int choice = 0; value.isString() && choice < NumberOfChoices; ++choice)
  {
    (trial->*Set)(choice);
    if (value.asString() == (trial->*Name)())
    {
      (property->*Set)(choice);
      return true;
    }
  }
  return false;
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

template <void (Property::*Set)(bool)>
bool SetSwitch(Property* property, const Json::Value& value)
{
  if (value.isBool())
  {
    (property->*Set)(value.asBool());
  }
  return value.isBool();
}

template <void (Property::*Set)(double)>
bool SetNumber(Property* property, const Json::Value& value)
{
  if (value.isNumeric())
  {
    (property->*Set)(value.asDouble());
  }
  return value.isNumeric();
}

bool HasNumbers(const Json::Value& list, unsigned int count)
{
  return list.isArray() && list.size() == count &&
    std::all_of(list.begin(), list.end(), [](const Json::Value& item) { return item.isNumeric(); });
}

bool SetAmbientColor(Property* property, const Json::Value& value)
{
  if (HasNumbers(value, 3))
  {
    property->SetAmbientColor(value[0].asDouble(), value[1].asDouble(), value[2].asDouble());
  }
  return HasNumbers(value, 3);
}

bool IsIsosurface(const Json::Value& surface)
{
  const std::size_t keys = surface.isObject() && surface.isMember("Color") ? 3 : 2;
  return surface.isObject() && surface.size() == keys && surface["Value"].isNumeric() &&
    surface["Opacity"].isNumeric() && (keys == 2 || HasNumbers(surface["Color"], 3));
}

// All of the list, or none of it.
bool SetIsosurfaces(Property* property, const Json::Value& value)
{
  if (!value.isArray() || !std::all_of(value.begin(), value.end(), IsIsosurface))
  {
    return false;
  }
  property->RemoveAllIsosurfaces();
  for (const Json::Value& surface : value)
  {
    const double scalar = surface["Value"].asDouble();
    const double opacity = surface["Opacity"].asDouble();
    const Json::Value& color = surface["Color"];
    if (color.isNull())
    {
      property->AddIsosurface(scalar, opacity);
    }
    else
    {
      property->AddIsosurface(scalar, color[0].asDouble(), color[1].asDouble(), color[2].asDouble(), opacity);
    }
  }
  return true;
}

// In the order in which they are set: what depends on the model comes after it.
const Setting Settings[] = {
  { "ReflectanceModel", "\"VTK\", \"None\", \"BlinnPhong\", \"Ward\" or \"Lafortune\"",
    SetByName<Property::NumberOfReflectanceModels, &Property::SetReflectanceModel,
      &Property::GetReflectanceModelAsString> },
  { "Glossiness", "a number, with ReflectanceModel BlinnPhong, Ward or Lafortune", SetGlossiness },
  { "AnisotropyScale", "a number, with ReflectanceModel Ward or Lafortune", SetAnisotropyScale },
  { "ScatteringAnisotropy", "a number in [-1, 1]", SetScatteringAnisotropy },
  { "SpecularFromExtinction", "true or false", SetSwitch<&Property::SetSpecularFromExtinction> },
  { "FrameSource", "\"Covariance\" or \"Curvature\"",
    SetByName<Property::Curvature + 1, &Property::SetFrameSource, &Property::GetFrameSourceAsString> },
  { "IntegrationSpace", "\"Physical\" or \"Data\"",
    SetByName<Property::Data + 1, &Property::SetIntegrationSpace, &Property::GetIntegrationSpaceAsString> },
  { "Classification", "\"Post\" or \"PreIntegrated\"",
    SetByName<Property::PreIntegrated + 1, &Property::SetClassification,
      &Property::GetClassificationAsString> },
  { "ScalarOpacityUnitInterval", "a number of at least 0",
    SetNumber<&Property::SetScalarOpacityUnitInterval> },
  { "Isosurfaces",
    "a list of {\"Value\": number, \"Opacity\": number in [0, 1], \"Color\": [red, green, blue]}, the color "
    "optional",
    SetIsosurfaces },
  { "Silhouette", "\"Off\", \"Exact\", \"Clamped\" or \"Gradient\"",
    SetByName<Property::Gradient + 1, &Property::SetSilhouette, &Property::GetSilhouetteAsString> },
  { "TransmittedLight", "\"Off\", \"Diffuse\" or \"DiffuseAndSpecular\"",
    SetByName<Property::DiffuseAndSpecular + 1, &Property::SetTransmittedLight,
      &Property::GetTransmittedLightAsString> },
  { "Occlusion", "true or false", SetSwitch<&Property::SetOcclusion> },
  { "OcclusionAngle", "a number in [0, 80]", SetNumber<&Property::SetOcclusionAngle> },
  { "AmbientColor", "[red, green, blue], each in [0, 1]", SetAmbientColor },
  { "Shadows", "true or false", SetSwitch<&Property::SetShadows> },
  { "ShadowAngle", "a number in [0, 80]", SetNumber<&Property::SetShadowAngle> },
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
