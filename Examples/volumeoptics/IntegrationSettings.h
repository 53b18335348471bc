// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How opacity adds up along a ray, as a part of the transfer function: in physical or data space, with
// isosurfaces, silhouettes and transmitted light. docs/transfer-function.md has the keys.

#ifndef IntegrationSettings_h
#define IntegrationSettings_h

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

class vtkOpticsVolumeProperty;

struct IntegrationSettings
{
  std::string Space = "physical";      // see IntegrationSpaces()
  std::string Classification = "post"; // see Classifications()
  double UnitInterval = 0.0;           // 0: one hundredth of the opacity function's range
  // value, opacity or value, red, green, blue, opacity
  std::vector<std::vector<double>> Isosurfaces;
  std::string Silhouette = "off";       // see Silhouettes()
  std::string TransmittedLight = "off"; // see TransmittedLights()
};

// Names in the order of vtkOpticsVolumeProperty's choices.
const std::vector<std::string>& IntegrationSpaces();
const std::vector<std::string>& Classifications();
const std::vector<std::string>& Silhouettes();
const std::vector<std::string>& TransmittedLights();

// Puts the settings that are not the default into the object.
void PutIntegration(nlohmann::json& object, const IntegrationSettings& settings);
// Takes the keys that are there. Throws UserError.
IntegrationSettings GetIntegration(const nlohmann::json& object);
bool IsIntegrationKey(const std::string& key);

// Throws UserError, with the remedy, where settings contradict each other.
void CheckIntegration(const IntegrationSettings& settings, bool shade);
void Apply(const IntegrationSettings& settings, vtkOpticsVolumeProperty* property);

#endif
