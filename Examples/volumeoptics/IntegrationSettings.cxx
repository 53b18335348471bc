// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "IntegrationSettings.h"

#include "UserError.h"

#include "vtkOpticsVolumeProperty.h"

#include <algorithm>
#include <cmath>

using nlohmann::json;

namespace
{
struct Choice
{
  const char* Key;
  std::string IntegrationSettings::*Value;
  const std::vector<std::string>& (*Names)();
};

const Choice Choices[] = { { "integration", &IntegrationSettings::Space, IntegrationSpaces },
  { "classification", &IntegrationSettings::Classification, Classifications },
  { "silhouette", &IntegrationSettings::Silhouette, Silhouettes },
  { "transmittedLight", &IntegrationSettings::TransmittedLight, TransmittedLights } };
const char* const UnitIntervalKey = "unitInterval";
const char* const IsosurfacesKey = "isosurfaces";

int IndexOf(const std::string& name, const std::vector<std::string>& names)
{
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::string Joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

void CheckName(const Choice& choice, const IntegrationSettings& settings)
{
  const std::string& name = settings.*choice.Value;
  if (IndexOf(name, choice.Names()) == static_cast<int>(choice.Names().size()))
  {
    throw UserError(std::string(choice.Key) + " '" + name + "' is none of " + Joined(choice.Names()));
  }
}

void CheckIsosurface(const std::vector<double>& surface)
{
  const bool isFinite =
    std::all_of(surface.begin(), surface.end(), [](double x) { return std::isfinite(x); });
  const bool isInRange = std::all_of(surface.begin() + std::min<std::size_t>(surface.size(), 1),
    surface.end(), [](double x) { return x >= 0.0 && x <= 1.0; });
  if ((surface.size() != 2 && surface.size() != 5) || !isFinite || !isInRange)
  {
    throw UserError("an isosurface is VALUE,OPACITY or VALUE,R,G,B,OPACITY, opacity and colour in [0, 1]");
  }
}
}

const std::vector<std::string>& IntegrationSpaces()
{
  static const std::vector<std::string> names = { "physical", "data" };
  return names;
}

const std::vector<std::string>& Classifications()
{
  static const std::vector<std::string> names = { "post", "pre-integrated" };
  return names;
}

const std::vector<std::string>& Silhouettes()
{
  static const std::vector<std::string> names = { "off", "exact", "clamped", "gradient" };
  return names;
}

const std::vector<std::string>& TransmittedLights()
{
  static const std::vector<std::string> names = { "off", "diffuse", "diffuse-and-specular" };
  return names;
}

void PutIntegration(json& object, const IntegrationSettings& settings)
{
  const IntegrationSettings defaults;
  for (const Choice& choice : Choices)
  {
    if (settings.*choice.Value != defaults.*choice.Value)
    {
      object[choice.Key] = settings.*choice.Value;
    }
  }
  if (settings.UnitInterval != defaults.UnitInterval)
  {
    object[UnitIntervalKey] = settings.UnitInterval;
  }
  if (!settings.Isosurfaces.empty())
  {
    object[IsosurfacesKey] = settings.Isosurfaces;
  }
}

IntegrationSettings GetIntegration(const json& object)
{
  IntegrationSettings settings;
  for (const Choice& choice : Choices)
  {
    settings.*choice.Value = object.value(choice.Key, settings.*choice.Value);
  }
  settings.UnitInterval = object.value(UnitIntervalKey, settings.UnitInterval);
  settings.Isosurfaces = object.value(IsosurfacesKey, settings.Isosurfaces);
  for (const Choice& choice : Choices)
  {
    CheckName(choice, settings);
  }
  if (!(settings.UnitInterval >= 0.0))
  {
    throw UserError("unitInterval must be 0 or above");
  }
  std::for_each(settings.Isosurfaces.begin(), settings.Isosurfaces.end(), CheckIsosurface);
  return settings;
}

bool IsIntegrationKey(const std::string& key)
{
  return key == UnitIntervalKey || key == IsosurfacesKey ||
    std::any_of(
      std::begin(Choices), std::end(Choices), [&](const Choice& choice) { return key == choice.Key; });
}

void CheckIntegration(const IntegrationSettings& settings, bool shade)
{
  const bool needsDataSpace =
    !settings.Isosurfaces.empty() || settings.Silhouette != "off" || settings.TransmittedLight != "off";
  if (needsDataSpace && settings.Space != "data")
  {
    throw UserError("Isosurfaces, silhouettes and transmitted light belong to the integral "
                    "in data space. Add --integration data.");
  }
  if (settings.TransmittedLight != "off" && !shade)
  {
    throw UserError("Transmitted light needs lights. Set \"shade\": true in the transfer function.");
  }
}

void Apply(const IntegrationSettings& settings, vtkOpticsVolumeProperty* property)
{
  property->SetIntegrationSpace(IndexOf(settings.Space, IntegrationSpaces()));
  property->SetClassification(IndexOf(settings.Classification, Classifications()));
  property->SetScalarOpacityUnitInterval(settings.UnitInterval);
  property->SetSilhouette(IndexOf(settings.Silhouette, Silhouettes()));
  property->SetTransmittedLight(IndexOf(settings.TransmittedLight, TransmittedLights()));
  property->RemoveAllIsosurfaces();
  for (const std::vector<double>& surface : settings.Isosurfaces)
  {
    if (surface.size() == 2)
    {
      property->AddIsosurface(surface[0], surface[1]);
    }
    else
    {
      property->AddIsosurface(surface[0], surface[1], surface[2], surface[3], surface[4]);
    }
  }
}
