// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour and opacity of a volume, with VTK's shading coefficients: from a JSON file, a preset or the
// data's own histogram. The format is described in docs/transfer-function.md.

#ifndef TransferFunction_h
#define TransferFunction_h

#include "IntegrationSettings.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkVolumeProperty;

struct TransferFunction
{
  std::vector<std::array<double, 2>> Opacity; // value, opacity per UnitDistance
  std::vector<std::array<double, 4>> Color;   // value, red, green, blue
  double UnitDistance = 1.0;
  bool Shade = true;
  double Ambient = 0.1;
  double Diffuse = 0.7;
  double Specular = 0.4;
  double SpecularPower = 20.0;
  IntegrationSettings Integration;
  // Only the largest region above Isolate is shown, where HasIsolate.
  bool HasIsolate = false;
  double Isolate = 0.0;
};

void to_json(nlohmann::json& json, const TransferFunction& function);
void from_json(const nlohmann::json& json, TransferFunction& function);

TransferFunction ReadTransferFunction(const std::string& path); // throws UserError
std::vector<std::string> PresetNames();
TransferFunction Preset(const std::string& name);
// A ramp over the upper values of the histogram, in a colour that is no statement about the data.
TransferFunction FromData(vtkImageData* image);

void Apply(const TransferFunction& function, vtkVolumeProperty* property);

#endif
