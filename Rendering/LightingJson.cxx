// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingJson.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
const char* const RangeKeys[] = { "RangeA", "RangeB" };
const char* const CurveKeys[] = { "CurveA", "CurveB" };
const double LargestSoftness = 1.0e30;
const double LargestDimension = 4096.0;

//------------------------------------------------------------------------------
Json::Value CurveToJson(vtkPiecewiseFunction* curve)
{
  Json::Value points(Json::arrayValue);
  for (int i = 0; i < curve->GetSize(); ++i)
  {
    double node[4]; // scalar, value, midpoint, sharpness
    curve->GetNodeValue(i, node);
    points.append(JsonNumbers(node, 4));
  }
  return points;
}

vtkSmartPointer<vtkPiecewiseFunction> CurveFromJson(const JsonPart& points)
{
  auto curve = vtkSmartPointer<vtkPiecewiseFunction>::New();
  for (int i = 0; i < points.Size(); ++i)
  {
    const bool isPlain = points.At(i).Size() == 2;
    std::vector<double> node = points.At(i).Numbers(isPlain ? 2 : 4);
    if (isPlain)
    {
      node.insert(node.end(), { 0.5, 0.0 });
    }
    curve->AddPoint(node[0], node[1], std::clamp(node[2], 0.0, 1.0), std::clamp(node[3], 0.0, 1.0));
  }
  return curve;
}

//------------------------------------------------------------------------------
Json::Value BoundaryToJson(const LightingBoundary& boundary)
{
  Json::Value object;
  for (int side = 0; side < 2; ++side)
  {
    const LightingMaterial& material = boundary.Materials[side];
    object[material.Curve ? CurveKeys[side] : RangeKeys[side]] =
      material.Curve ? CurveToJson(material.Curve) : JsonNumbers(material.Range.data(), 2);
  }
  object["Softness"] = boundary.Softness;
  for (int i = 0; i < 3; ++i)
  {
    object[CoefficientNames[i]] = boundary.Coefficients[i];
  }
  return object;
}

LightingBoundary BoundaryFromJson(const JsonPart& object)
{
  object.AllowKeys({ "RangeA", "RangeB", "CurveA", "CurveB", "Softness", "Ambient", "Diffuse", "Specular" });
  LightingBoundary boundary;
  for (int side = 0; side < 2; ++side)
  {
    LightingMaterial& material = boundary.Materials[side];
    if (object.Has(CurveKeys[side]))
    {
      material.Curve = CurveFromJson(object.At(CurveKeys[side]));
      continue;
    }
    const std::vector<double> ends = object.Numbers(RangeKeys[side], 2);
    material.Range = { std::min(ends[0], ends[1]), std::max(ends[0], ends[1]) };
  }
  boundary.Softness = object.Number("Softness", 0.0, LargestSoftness, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    boundary.Coefficients[i] = object.Number(CoefficientNames[i], 0.0, 1.0, 0.0);
  }
  return boundary;
}

//------------------------------------------------------------------------------
// Values are written as they count: integers relative to their type's largest.
Json::Value TableToJson(vtkImageData* image)
{
  Json::Value object;
  const int* dimensions = image->GetDimensions();
  const double sizes[] = { static_cast<double>(dimensions[0]), static_cast<double>(dimensions[1]) };
  double first[3];
  image->GetPoint(0, first);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  object["Origin"] = JsonNumbers(first, 2);
  object["Spacing"] = JsonNumbers(image->GetSpacing(), 2);
  object["Dimensions"] = JsonNumbers(sizes, 2);
  object["Components"] = 3;
  object["Values"] = Json::Value(Json::arrayValue);
  for (vtkIdType point = 0; values && point < vtkIdType(dimensions[0]) * dimensions[1]; ++point)
  {
    for (const double value : TableCoefficients(values, point))
    {
      object["Values"].append(value);
    }
  }
  return object;
}

vtkSmartPointer<vtkImageData> TableFromJson(const JsonPart& object)
{
  object.AllowKeys({ "Origin", "Spacing", "Dimensions", "Components", "Values" });
  const std::vector<double> origin = object.Numbers("Origin", 2);
  const std::vector<double> spacing = object.Numbers("Spacing", 2);
  const JsonPart dimensions = object.At("Dimensions");
  const std::vector<double> sizes = dimensions.Numbers(2);
  dimensions.RequireEach(1.0, LargestDimension);
  const int components = static_cast<int>(object.Number("Components", 1.0, 3.0, 3.0));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(sizes[0]), static_cast<int>(sizes[1]), 1);
  image->SetOrigin(origin[0], origin[1], 0.0);
  image->SetSpacing(spacing[0], spacing[1], 1.0);
  image->AllocateScalars(VTK_DOUBLE, components);
  const std::vector<double> values =
    object.Numbers("Values", static_cast<std::size_t>(image->GetNumberOfPoints()) * components);
  std::copy(values.begin(), values.end(), static_cast<double*>(image->GetScalarPointer()));
  return image;
}
}

//------------------------------------------------------------------------------
Json::Value LightingToJson(const LightingFunction& function)
{
  Json::Value document(Json::objectValue);
  document["Boundaries"] = Json::Value(Json::arrayValue);
  for (const LightingBoundary& boundary : function.Boundaries)
  {
    document["Boundaries"].append(BoundaryToJson(boundary));
  }
  if (function.Image)
  {
    document["Table"] = TableToJson(function.Image);
  }
  return document;
}

LightingFunction LightingFromJson(const Json::Value& document)
{
  const JsonPart object(document, "");
  object.AllowKeys({ "Boundaries", "Table" });
  LightingFunction function;
  for (int i = 0; object.Has("Boundaries") && i < object.At("Boundaries").Size(); ++i)
  {
    function.Boundaries.push_back(BoundaryFromJson(object.At("Boundaries").At(i)));
  }
  if (object.Has("Table"))
  {
    function.Image = TableFromJson(object.At("Table"));
  }
  return function;
}
}
