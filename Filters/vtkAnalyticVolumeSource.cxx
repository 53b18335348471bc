// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnalyticVolumeSource.h"

#include "ParameterRange.h"
#include "AnalyticFields.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

vtkStandardNewMacro(vtkAnalyticVolumeSource);

static_assert(
  static_cast<int>(vtkAnalyticVolumeSource::NumberOfFields) == static_cast<int>(analytic::NumberOfFields),
  "the class and AnalyticFields.h list the same fields");

namespace
{
const char* const FieldNames[] = { "MarschnerLobb", "Sphere", "Ellipsoid", "Cylinder", "Torus",
  "PackedEllipsoids", "VortexTubes", "LinearRamp", "NoisyHomogeneous", "CoulombPotential",
  "CoulombPotentials", "HydrogenOrbital", "Buckyball", "Plant" };

// Progress and abort are looked at this many times.
const vtkIdType NumberOfPortions = 32;

// [0, 1] to the range of the type, see the class comment.
template <class Scalar>
Scalar FromUnitRange(double value)
{
  if (std::is_floating_point<Scalar>::value)
  {
    return static_cast<Scalar>(value);
  }
  const double largest = std::min(65535.0, static_cast<double>(std::numeric_limits<Scalar>::max()));
  return static_cast<Scalar>(std::lround(std::clamp(value, 0.0, 1.0) * largest));
}

// One row of the output, along x. Positions follow from the index in the whole grid alone, so that
// pieces agree.
template <class Scalar>
void SampleRow(const analytic::AnalyticField& field, vtkImageData* output, int y, int z)
{
  const int* extent = output->GetExtent();
  const double* origin = output->GetOrigin();
  const double* spacing = output->GetSpacing();
  auto* scalars = static_cast<Scalar*>(output->GetScalarPointer(extent[0], y, z));
  for (int x = extent[0]; x <= extent[1]; ++x)
  {
    const analytic::Vector point = { origin[0] + x * spacing[0], origin[1] + y * spacing[1],
      origin[2] + z * spacing[2] };
    *scalars++ = FromUnitRange<Scalar>(field.Value(point));
  }
}

template <class Scalar>
void SampleRows(const analytic::AnalyticField& field, vtkImageData* output, vtkIdType first, vtkIdType last)
{
  const int* extent = output->GetExtent();
  const vtkIdType rowsInSlice = extent[3] - extent[2] + 1;
  vtkSMPTools::For(first, last, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType row = begin; row < end; ++row)
    {
      SampleRow<Scalar>(field, output, extent[2] + static_cast<int>(row % rowsInSlice),
        extent[4] + static_cast<int>(row / rowsInSlice));
    }
  });
}
}

//------------------------------------------------------------------------------
vtkAnalyticVolumeSource::vtkAnalyticVolumeSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
void vtkAnalyticVolumeSource::SetField(int field)
{
  volumeoptics::SetChoice(this, "Field", field, FieldNames, this->Field);
}

//------------------------------------------------------------------------------
const char* vtkAnalyticVolumeSource::GetFieldAsString()
{
  return FieldNames[this->Field];
}

//------------------------------------------------------------------------------
void vtkAnalyticVolumeSource::SetDimensions(int x, int y, int z)
{
  const int wanted[3] = { std::max(x, 1), std::max(y, 1), std::max(z, 1) };
  if (!std::equal(wanted, wanted + 3, this->Dimensions))
  {
    std::copy(wanted, wanted + 3, this->Dimensions);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAnalyticVolumeSource::SetSemiAxes(double x, double y, double z)
{
  const double wanted[3] = { std::max(x, 1.0e-30), std::max(y, 1.0e-30), std::max(z, 1.0e-30) };
  if (!std::equal(wanted, wanted + 3, this->SemiAxes))
  {
    std::copy(wanted, wanted + 3, this->SemiAxes);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAnalyticVolumeSource::SetBoundsToPackedEllipsoids()
{
  this->SetBounds(-250.0 / 512.0, 250.0 / 512.0, -92.0 / 512.0, 92.0 / 512.0, -1.0, 1.0);
}

//------------------------------------------------------------------------------
int vtkAnalyticVolumeSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  int extent[6];
  double origin[3];
  double spacing[3];
  for (int i = 0; i < 3; ++i)
  {
    const double low = this->Bounds[2 * i];
    const double length = this->Bounds[2 * i + 1] - low;
    const int cells = this->Dimensions[i] - 1;
    extent[2 * i] = 0;
    extent[2 * i + 1] = cells;
    origin[i] = cells > 0 ? low : low + length / 2.0;
    spacing[i] = cells > 0 ? length / cells : length;
  }
  vtkInformation* information = outputs->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  information->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(information, this->OutputScalarType, 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnalyticVolumeSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* information = outputs->GetInformationObject(0);
  vtkImageData* output =
    this->AllocateOutputData(information->Get(vtkDataObject::DATA_OBJECT()), information);
  output->GetPointData()->GetScalars()->SetName("Scalars");

  analytic::Parameters parameters;
  std::copy(this->SemiAxes, this->SemiAxes + 3, parameters.semiAxes.begin());
  std::copy(this->Axis, this->Axis + 3, parameters.axis.begin());
  parameters.radius = this->Radius;
  parameters.strength = this->Strength;
  parameters.minorRadius = this->MinorRadius;
  parameters.noiseAmplitude = this->NoiseAmplitude;
  parameters.noiseCellSize = this->NoiseCellSize;
  parameters.seed = static_cast<std::uint32_t>(this->Seed);
  const analytic::AnalyticField field(this->Field, parameters);

  const int* extent = output->GetExtent();
  const vtkIdType rows = static_cast<vtkIdType>(extent[3] - extent[2] + 1) * (extent[5] - extent[4] + 1);
  for (vtkIdType portion = 0; portion < NumberOfPortions && !this->GetAbortExecute(); ++portion)
  {
    const vtkIdType first = rows * portion / NumberOfPortions;
    const vtkIdType last = rows * (portion + 1) / NumberOfPortions;
    switch (output->GetScalarType())
    {
      vtkTemplateMacro(SampleRows<VTK_TT>(field, output, first, last));
    }
    this->UpdateProgress(static_cast<double>(portion + 1) / NumberOfPortions);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkAnalyticVolumeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto printVector = [&os, &indent](const char* name, const auto* values, int count) {
    os << indent << name << ":";
    for (int i = 0; i < count; ++i)
    {
      os << " " << values[i];
    }
    os << "\n";
  };
  os << indent << "Field: " << this->GetFieldAsString() << "\n";
  printVector("Dimensions", this->Dimensions, 3);
  printVector("Bounds", this->Bounds, 6);
  os << indent << "OutputScalarType: " << vtkImageScalarTypeNameMacro(this->OutputScalarType) << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "MinorRadius: " << this->MinorRadius << "\n";
  printVector("SemiAxes", this->SemiAxes, 3);
  printVector("Axis", this->Axis, 3);
  os << indent << "NoiseAmplitude: " << this->NoiseAmplitude << "\n";
  os << indent << "NoiseCellSize: " << this->NoiseCellSize << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
