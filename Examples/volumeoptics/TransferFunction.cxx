// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TransferFunction.h"

#include "ReadingGuard.h"
#include "UserError.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkImageHistogramStatistics.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <fstream>

using nlohmann::json;

namespace
{
// Beyond, a value is no float any more.
constexpr double LargestValue = 1e38;

bool IsIn(double number, double least, double largest)
{
  return number >= least && number <= largest;
}

// Points of a value and shares.
template <std::size_t Size>
void CheckPoints(const std::vector<std::array<double, Size>>& points, const char* key)
{
  const auto isRight = [](const std::array<double, Size>& point) {
    return IsIn(point[0], -LargestValue, LargestValue) &&
      std::all_of(point.begin() + 1, point.end(), [](double share) { return IsIn(share, 0.0, 1.0); });
  };
  if (points.empty() || !std::all_of(points.begin(), points.end(), isRight))
  {
    throw UserError(std::string(key) + " needs points, of values in [-1e38, 1e38] and shares in [0, 1]");
  }
}

void Check(const TransferFunction& function)
{
  CheckPoints(function.Opacity, "opacity");
  CheckPoints(function.Color, "color");
  if (!IsIn(function.UnitDistance, 1.0 / LargestValue, LargestValue))
  {
    throw UserError("unitDistance must be above 0");
  }
  for (const double number :
    { function.Ambient, function.Diffuse, function.Specular, function.SpecularPower })
  {
    if (!IsIn(number, 0.0, LargestValue))
    {
      throw UserError("ambient, diffuse, specular and specularPower must be in [0, 1e38]");
    }
  }
  if (!IsIn(function.Isolate, -LargestValue, LargestValue))
  {
    throw UserError("isolate must be in [-1e38, 1e38]");
  }
}
}

void to_json(json& object, const TransferFunction& function)
{
  object = { { "opacity", function.Opacity }, { "color", function.Color },
    { "unitDistance", function.UnitDistance }, { "shade", function.Shade }, { "ambient", function.Ambient },
    { "diffuse", function.Diffuse }, { "specular", function.Specular },
    { "specularPower", function.SpecularPower } };
  PutIntegration(object, function.Integration);
  if (function.HasIsolate)
  {
    object["isolate"] = function.Isolate;
  }
}

void from_json(const json& object, TransferFunction& function)
{
  for (const auto& item : object.items())
  {
    static const json known = TransferFunction{};
    if (!known.contains(item.key()) && item.key() != "isolate" && !IsIntegrationKey(item.key()))
    {
      throw UserError("unknown key '" + item.key() + "'");
    }
  }
  object.at("opacity").get_to(function.Opacity);
  object.at("color").get_to(function.Color);
  function.UnitDistance = object.value("unitDistance", function.UnitDistance);
  function.Shade = object.value("shade", function.Shade);
  function.Ambient = object.value("ambient", function.Ambient);
  function.Diffuse = object.value("diffuse", function.Diffuse);
  function.Specular = object.value("specular", function.Specular);
  function.SpecularPower = object.value("specularPower", function.SpecularPower);
  function.Integration = GetIntegration(object);
  function.HasIsolate = object.contains("isolate");
  function.Isolate = object.value("isolate", 0.0);
  Check(function);
}

TransferFunction ReadTransferFunction(const std::string& path)
{
  RequireFile(path);
  const ReadingGuard guard(path);
  std::ifstream file(path);
  if (!file)
  {
    throw UserError("The transfer function '" + path + "' cannot be opened. Check the path.");
  }
  try
  {
    return json::parse(file).get<TransferFunction>();
  }
  catch (const std::exception& error)
  {
    throw UserError("The transfer function '" + path + "' is not valid: " + error.what() +
      ". The format is in docs/transfer-function.md and in --help.");
  }
}

std::vector<std::string> PresetNames()
{
  return { "bone", "cranium", "muscle", "skin" };
}

// Values are Hounsfield units: air -1000, fat -100, muscle 50, bone above 200.
TransferFunction Preset(const std::string& name)
{
  TransferFunction function;
  function.HasIsolate = true;
  function.Isolate = -400.0;
  function.Diffuse = 0.45;
  function.Specular = 0.6;
  const std::vector<std::array<double, 4>> ivory = { { -1024.0, 0.8, 0.5, 0.4 }, { -150.0, 0.75, 0.45, 0.34 },
    { 60.0, 0.65, 0.28, 0.24 }, { 150.0, 0.7, 0.4, 0.3 }, { 230.0, 0.85, 0.74, 0.57 },
    { 500.0, 0.92, 0.84, 0.7 }, { 3100.0, 1.0, 0.97, 0.9 } };
  function.Color = ivory;
  if (name == "bone")
  {
    function.Opacity = { { -1024.0, 0.0 }, { 180.0, 0.0 }, { 280.0, 0.6 }, { 400.0, 0.95 }, { 3100.0, 1.0 } };
  }
  else if (name == "cranium")
  {
    // partial volumes at the border of the bone are dark: they trace its edges
    function.Opacity = { { -1024.0, 0.0 }, { -450.0, 0.0 }, { -300.0, 0.03 }, { -150.0, 0.06 },
      { 0.0, 0.015 }, { 80.0, 0.005 }, { 140.0, 0.005 }, { 190.0, 0.1 }, { 230.0, 0.2 }, { 260.0, 0.35 },
      { 400.0, 0.9 }, { 3100.0, 1.0 } };
    function.Color = { { -1024.0, 0.8, 0.5, 0.4 }, { -150.0, 0.8, 0.5, 0.38 }, { 60.0, 0.5, 0.2, 0.16 },
      { 190.0, 0.06, 0.03, 0.02 }, { 240.0, 0.2, 0.13, 0.08 }, { 320.0, 0.85, 0.72, 0.54 },
      { 500.0, 0.92, 0.84, 0.7 }, { 3100.0, 1.0, 0.97, 0.9 } };
    function.Ambient = 0.05;
    function.Diffuse = 0.4;
    function.Specular = 0.9;
  }
  else if (name == "muscle")
  {
    function.Opacity = { { -1024.0, 0.0 }, { -20.0, 0.0 }, { 20.0, 0.08 }, { 80.0, 0.25 }, { 180.0, 0.3 },
      { 250.0, 0.8 }, { 3100.0, 1.0 } };
  }
  else if (name == "skin")
  {
    function.Opacity = { { -1024.0, 0.0 }, { -450.0, 0.0 }, { -300.0, 0.5 }, { -150.0, 0.9 },
      { 3100.0, 1.0 } };
    function.Color = { { -1024.0, 0.87, 0.65, 0.53 }, { 3100.0, 0.93, 0.75, 0.63 } };
  }
  return function;
}

TransferFunction FromData(vtkImageData* image)
{
  vtkNew<vtkImageHistogramStatistics> statistics;
  statistics->SetInputData(image);
  statistics->SetAutoRangePercentiles(50.0, 99.9);
  statistics->SetAutoRangeExpansionFactors(0.0, 0.0);
  statistics->Update();
  double range[2];
  statistics->GetAutoRange(range);
  if (!(range[1] > range[0]))
  {
    image->GetScalarRange(range);
  }
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  const auto at = [&](double fraction) { return range[0] + fraction * width; };

  double bounds[6];
  image->GetBounds(bounds);
  TransferFunction function;
  function.Opacity = { { at(0.15), 0.0 }, { at(0.4), 0.1 }, { at(0.6), 0.6 }, { at(1.0), 0.9 } };
  function.Color = { { at(0.0), 0.35, 0.45, 0.6 }, { at(0.5), 0.85, 0.8, 0.7 },
    { at(1.0), 0.98, 0.96, 0.9 } };
  const double* spacing = image->GetSpacing();
  function.UnitDistance = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  return function;
}

void Apply(const TransferFunction& function, vtkVolumeProperty* property)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AllowDuplicateScalarsOn(); // two points at one value are a jump
  for (const auto& [value, alpha] : function.Opacity)
  {
    opacity->AddPoint(value, alpha);
  }
  vtkNew<vtkColorTransferFunction> color;
  color->AllowDuplicateScalarsOn();
  for (const auto& [value, red, green, blue] : function.Color)
  {
    color->AddRGBPoint(value, red, green, blue);
  }
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  property->SetScalarOpacityUnitDistance(function.UnitDistance);
  property->SetShade(function.Shade);
  property->SetAmbient(function.Ambient);
  property->SetDiffuse(function.Diffuse);
  property->SetSpecular(function.Specular);
  property->SetSpecularPower(function.SpecularPower);
  property->SetInterpolationTypeToLinear();
}
