// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingTable.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// Position between two points of an image along one axis.
struct AxisPosition
{
  int Point;
  int Next;
  double Weight; // of Next
};

AxisPosition PositionAlong(vtkImageData* image, int axis, double scalar)
{
  const int* extent = image->GetExtent();
  const int count = extent[2 * axis + 1] - extent[2 * axis] + 1;
  const double spacing = image->GetSpacing()[axis];
  const double index = (scalar - image->GetOrigin()[axis]) / spacing - extent[2 * axis];
  const double inside = std::isfinite(index) ? std::clamp(index, 0.0, count - 1.0) : 0.0;
  const int point = static_cast<int>(inside);
  return { point, std::min(point + 1, count - 1), inside - point };
}

double ValueAt(vtkDataArray* values, vtkIdType point, int component)
{
  const bool isReal = values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE;
  const double value = values->GetComponent(point, component) / (isReal ? 1.0 : values->GetDataTypeMax());
  return std::isnan(value) ? 0.0 : std::clamp(value, 0.0, 1.0);
}

void AddTo(LightingCoefficients& sum, const LightingCoefficients& coefficients, double weight)
{
  for (int i = 0; i < 3; ++i)
  {
    sum[i] += weight * coefficients[i];
  }
}

double DensityAt(vtkPiecewiseFunction* density, double scalar)
{
  const double value = density && density->GetSize() > 0 ? density->GetValue(scalar) : 0.0;
  return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
}
}

vtkMTimeType LatestChange(const LightingFunction& function)
{
  vtkMTimeType time = function.Image ? function.Image->GetMTime() : 0;
  for (const LightingBoundary& boundary : function.Boundaries)
  {
    for (const LightingMaterial& material : boundary.Materials)
    {
      time = material.Curve ? std::max(time, material.Curve->GetMTime()) : time;
    }
  }
  return time;
}

LightingCoefficients TableCoefficients(vtkDataArray* values, vtkIdType point)
{
  LightingCoefficients coefficients = { 0.0, 0.0, 0.0 };
  const int components = values->GetNumberOfComponents();
  for (int i = 0; i < 3; ++i)
  {
    const int component = components == 1 ? 0 : i;
    coefficients[i] = component < components ? ValueAt(values, point, component) : 0.0;
  }
  return coefficients;
}

LightingCoefficients ImageCoefficients(vtkImageData* image, double s1, double s2)
{
  LightingCoefficients sum = { 0.0, 0.0, 0.0 };
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!values || values->GetNumberOfTuples() == 0)
  {
    return sum;
  }
  const AxisPosition at[2] = { PositionAlong(image, 0, s1), PositionAlong(image, 1, s2) };
  const vtkIdType columns = image->GetDimensions()[0];
  for (int corner = 0; corner < 4; ++corner)
  {
    const bool right = corner % 2 == 1;
    const bool up = corner / 2 == 1;
    const double weight =
      (right ? at[0].Weight : 1.0 - at[0].Weight) * (up ? at[1].Weight : 1.0 - at[1].Weight);
    const vtkIdType point = (right ? at[0].Next : at[0].Point) + columns * (up ? at[1].Next : at[1].Point);
    AddTo(sum, TableCoefficients(values, point), weight);
  }
  return sum;
}

LightingCoefficients Coefficients(const LightingFunction& function, double s1, double s2)
{
  LightingCoefficients sum = ImageCoefficients(function.Image, s1, s2);
  for (const LightingBoundary& boundary : function.Boundaries)
  {
    AddTo(sum, boundary.Coefficients, boundary.Weight(s1, s2));
  }
  std::for_each(sum.begin(), sum.end(), [](double& value) { value = std::min(value, 1.0); });
  return sum;
}

std::vector<float> LightingTable(
  const LightingFunction& function, const double range[2], int size, vtkPiecewiseFunction* density)
{
  std::vector<std::array<std::vector<double>, 2>> weights;
  for (const LightingBoundary& boundary : function.Boundaries)
  {
    weights.push_back(MeanWeights(boundary, range, size));
  }
  const double width = range[1] / size - range[0] / size;
  std::vector<double> centres;
  std::vector<double> densities;
  for (int i = 0; i < size; ++i)
  {
    centres.push_back(range[0] + (i + 0.5) * width);
    densities.push_back(DensityAt(density, centres[i]));
  }
  std::vector<float> rgba;
  rgba.reserve(4 * static_cast<std::size_t>(size) * size);
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      LightingCoefficients sum = ImageCoefficients(function.Image, centres[column], centres[row]);
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        const auto& [a, b] = weights[i];
        AddTo(sum, function.Boundaries[i].Coefficients, UnorderedPair(a[column], b[column], a[row], b[row]));
      }
      for (const double value : sum)
      {
        rgba.push_back(static_cast<float>(std::min(value, 1.0)));
      }
      rgba.push_back(static_cast<float>(densities[column] - densities[row]));
    }
  }
  return rgba;
}

void FillTableImage(const std::vector<float>& rgba, const double range[2], int size, vtkImageData* table)
{
  const double width = (range[1] - range[0]) / size;
  table->SetDimensions(size, size, 1);
  table->SetOrigin(range[0] + 0.5 * width, range[0] + 0.5 * width, 0.0);
  table->SetSpacing(width != 0.0 ? width : 1.0, width != 0.0 ? width : 1.0, 1.0);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("LightingTransferFunction");
  scalars->SetNumberOfComponents(4);
  scalars->SetNumberOfTuples(table->GetNumberOfPoints());
  std::copy(rgba.begin(), rgba.end(), scalars->GetPointer(0));
  table->GetPointData()->SetScalars(scalars);
}
}
