// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLightingTransferFunction.h"

#include "BoundarySearch.h"
#include "JsonErrors.h"
#include "LightingJson.h"
#include "LightingTable.h"
#include "ParameterRange.h"

#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

using volumeoptics::LightingBoundary;

vtkStandardNewMacro(vtkLightingTransferFunction);

namespace
{
const volumeoptics::LightingCoefficients GuessedCoefficients = { 0.2, 0.7, 0.4 };
const char* const Subject = "The lighting transfer function";

bool IsFinite(const double range[2])
{
  return std::isfinite(range[0]) && std::isfinite(range[1]);
}
}

class vtkLightingTransferFunction::Internals
{
public:
  volumeoptics::LightingFunction Function;

  int Append(
    vtkLightingTransferFunction* owner, const LightingBoundary& boundary, double ka, double kd, double ks)
  {
    this->Function.Boundaries.push_back(boundary);
    owner->Modified();
    const int index = owner->GetNumberOfBoundaries() - 1;
    owner->SetCoefficients(index, ka, kd, ks);
    return index;
  }
};

//------------------------------------------------------------------------------
vtkLightingTransferFunction::vtkLightingTransferFunction()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkLightingTransferFunction::~vtkLightingTransferFunction() = default;

//------------------------------------------------------------------------------
bool vtkLightingTransferFunction::HasBoundary(int boundary, const char* method)
{
  const int count = this->GetNumberOfBoundaries();
  if (boundary < 0 || boundary >= count)
  {
    vtkErrorMacro(<< method << ": there is no boundary " << boundary
                  << ". Boundaries are numbered from 0, and there are " << count << ".");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkLightingTransferFunction::AddBoundary(
  const double rangeA[2], const double rangeB[2], double ka, double kd, double ks)
{
  if (!IsFinite(rangeA) || !IsFinite(rangeB))
  {
    vtkErrorMacro(<< "The ranges [" << rangeA[0] << ", " << rangeA[1] << "] and [" << rangeB[0] << ", "
                  << rangeB[1]
                  << "] are not finite; no boundary is added. Take the ends of the scalar range.");
    return -1;
  }
  LightingBoundary boundary;
  const double* const ranges[] = { rangeA, rangeB };
  for (int side = 0; side < 2; ++side)
  {
    const auto ordered = std::minmax(ranges[side][0], ranges[side][1]);
    boundary.Materials[side].Range = { ordered.first, ordered.second };
  }
  return this->Internal->Append(this, boundary, ka, kd, ks);
}

//------------------------------------------------------------------------------
int vtkLightingTransferFunction::AddBoundary(
  vtkPiecewiseFunction* curveA, vtkPiecewiseFunction* curveB, double ka, double kd, double ks)
{
  if (!curveA || !curveB)
  {
    vtkErrorMacro("A boundary needs two curves; no boundary is added.");
    return -1;
  }
  LightingBoundary boundary;
  boundary.Materials[0].Curve = curveA;
  boundary.Materials[1].Curve = curveB;
  return this->Internal->Append(this, boundary, ka, kd, ks);
}

//------------------------------------------------------------------------------
int vtkLightingTransferFunction::GetNumberOfBoundaries()
{
  return static_cast<int>(this->Internal->Function.Boundaries.size());
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::RemoveBoundary(int boundary)
{
  if (this->HasBoundary(boundary, "RemoveBoundary"))
  {
    auto& boundaries = this->Internal->Function.Boundaries;
    boundaries.erase(boundaries.begin() + boundary);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::RemoveAllBoundaries()
{
  if (!this->Internal->Function.Boundaries.empty())
  {
    this->Internal->Function.Boundaries.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::SetRange(int boundary, int side, double low, double high)
{
  const double range[2] = { low, high };
  if (!this->HasBoundary(boundary, "SetRange"))
  {
    return;
  }
  if (side < 0 || side > 1 || !IsFinite(range) || this->GetCurve(boundary, side))
  {
    vtkErrorMacro(<< "SetRange: [" << low << ", " << high << "] of side " << side << " of boundary "
                  << boundary
                  << " is not set. Sides are 0 and 1, ends are finite, and a curve is edited itself.");
    return;
  }
  const std::array<double, 2> ordered = { std::min(low, high), std::max(low, high) };
  auto& former = this->Internal->Function.Boundaries[boundary].Materials[side].Range;
  if (former != ordered)
  {
    former = ordered;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::GetRange(int boundary, int side, double range[2])
{
  range[0] = range[1] = 0.0;
  if (!this->HasBoundary(boundary, "GetRange"))
  {
    return;
  }
  const auto& material = this->Internal->Function.Boundaries[boundary].Materials[side != 0];
  const double* ends = material.Curve ? material.Curve->GetRange() : material.Range.data();
  std::copy(ends, ends + 2, range);
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::SetSoftness(int boundary, double softness)
{
  if (this->HasBoundary(boundary, "SetSoftness"))
  {
    volumeoptics::SetWithinRange(
      this, "Softness", softness, 0.0, 1.0e30, this->Internal->Function.Boundaries[boundary].Softness);
  }
}

//------------------------------------------------------------------------------
double vtkLightingTransferFunction::GetSoftness(int boundary)
{
  return this->HasBoundary(boundary, "GetSoftness") ? this->Internal->Function.Boundaries[boundary].Softness
                                                    : 0.0;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::SetCoefficients(int boundary, double ka, double kd, double ks)
{
  if (!this->HasBoundary(boundary, "SetCoefficients"))
  {
    return;
  }
  auto& coefficients = this->Internal->Function.Boundaries[boundary].Coefficients;
  const double values[] = { ka, kd, ks };
  for (int i = 0; i < 3; ++i)
  {
    volumeoptics::SetWithinRange(
      this, volumeoptics::CoefficientNames[i], values[i], 0.0, 1.0, coefficients[i]);
  }
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::GetCoefficients(int boundary, double coefficients[3])
{
  std::fill(coefficients, coefficients + 3, 0.0);
  if (this->HasBoundary(boundary, "GetCoefficients"))
  {
    const auto& values = this->Internal->Function.Boundaries[boundary].Coefficients;
    std::copy(values.begin(), values.end(), coefficients);
  }
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkLightingTransferFunction::GetCurve(int boundary, int side)
{
  return this->HasBoundary(boundary, "GetCurve")
    ? this->Internal->Function.Boundaries[boundary].Materials[side != 0].Curve.Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::SetTableFromImage(vtkImageData* image)
{
  if (this->Internal->Function.Image != image)
  {
    this->Internal->Function.Image = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkLightingTransferFunction::GetTableImage()
{
  return this->Internal->Function.Image;
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::ShallowCopy(vtkLightingTransferFunction* source)
{
  if (source && source != this)
  {
    this->Internal->Function = source->Internal->Function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkLightingTransferFunction::InitializeFromHistogram(vtkImageData* histogram, int number)
{
  if (!histogram || !histogram->GetPointData()->GetScalars() ||
    histogram->GetDimensions()[0] != histogram->GetDimensions()[1])
  {
    vtkErrorMacro("There is no square histogram to find boundaries in; nothing is changed. Give the updated "
                  "output of vtkGradientAlignedHistogram.");
    return 0;
  }
  auto& boundaries = this->Internal->Function.Boundaries;
  boundaries = volumeoptics::FindBoundaries(histogram, number);
  for (LightingBoundary& boundary : boundaries)
  {
    boundary.Coefficients = GuessedCoefficients;
  }
  this->Modified();
  return this->GetNumberOfBoundaries();
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::Evaluate(double s1, double s2, double coefficients[3])
{
  const auto values = volumeoptics::Coefficients(this->Internal->Function, s1, s2);
  std::copy(values.begin(), values.end(), coefficients);
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::GetTable(
  const double range[2], int size, std::vector<float>& rgba, vtkPiecewiseFunction* density)
{
  rgba.clear();
  if (size < 1 || size > LargestTableSize || !IsFinite(range))
  {
    vtkErrorMacro(<< "A table of size " << size << " over [" << range[0] << ", " << range[1]
                  << "] is not possible. The size is 1 to " << LargestTableSize << ", the range finite.");
    return;
  }
  rgba = volumeoptics::LightingTable(this->Internal->Function, range, size, density);
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::GetTable(
  const double range[2], int size, vtkImageData* table, vtkPiecewiseFunction* density)
{
  table->Initialize();
  std::vector<float> rgba;
  this->GetTable(range, size, rgba, density);
  if (!rgba.empty())
  {
    volumeoptics::FillTableImage(rgba, range, size, table);
  }
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunction::WriteJson(const char* fileName)
{
  return volumeoptics::TellJsonErrors(this, Subject, fileName,
    [&] { volumeoptics::WriteJsonFile(fileName, volumeoptics::LightingToJson(this->Internal->Function)); });
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunction::ReadJson(const char* fileName)
{
  return volumeoptics::TellJsonErrors(this, Subject, fileName, [&] {
    this->Internal->Function = volumeoptics::LightingFromJson(volumeoptics::ReadJsonObject(fileName));
    this->Modified();
  });
}

//------------------------------------------------------------------------------
std::string vtkLightingTransferFunction::WriteJsonString()
{
  return volumeoptics::FormatJson(volumeoptics::LightingToJson(this->Internal->Function));
}

//------------------------------------------------------------------------------
bool vtkLightingTransferFunction::ReadJsonString(const std::string& text)
{
  return volumeoptics::TellJsonErrors(this, Subject, "of a text", [&] {
    this->Internal->Function = volumeoptics::LightingFromJson(volumeoptics::ParseJsonObject(text));
    this->Modified();
  });
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLightingTransferFunction::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), volumeoptics::LatestChange(this->Internal->Function));
}

//------------------------------------------------------------------------------
void vtkLightingTransferFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const volumeoptics::LightingFunction& function = this->Internal->Function;
  os << indent << "Boundaries: " << function.Boundaries.size() << "\n";
  for (const LightingBoundary& boundary : function.Boundaries)
  {
    boundary.Print(os, indent.GetNextIndent());
  }
  os << indent << "TableImage: " << function.Image.Get() << "\n";
}
