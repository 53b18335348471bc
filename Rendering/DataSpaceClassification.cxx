// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataSpaceClassification.h"

#include "Optics.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPreIntegratedTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
namespace optics
{
// The text that the GPU compiles, as members of what it reads from.
struct SegmentIntegral
{
  using vec4 = glm::dvec4;

  const DataSpaceClassification& Classification;

  vec4 TableEntry(double front, double back)
  {
    vec4 entry;
    this->Classification.GetTable()->GetEntry(
      this->Classification.Denormalize(front), this->Classification.Denormalize(back), &entry[0]);
    return entry;
  }
  int NumberOfIsosurfaces() { return static_cast<int>(this->Classification.GetIsosurfaces().size()); }
  double Isovalue(int index) { return this->Classification.GetIsosurfaces()[index].Value; }
  vec4 IsosurfaceColor(int index) { return this->Classification.GetIsosurfaces()[index].Color; }
  int SilhouetteMode() { return this->Classification.GetSilhouette(); }

#define float double
#include "glsl/DataSpaceInterior.glsl"
#include "glsl/DataSpaceSegment.glsl"
#undef float
};
}

// A gray function as a colour function with the same nodes.
vtkSmartPointer<vtkColorTransferFunction> MakeColorFunction(vtkVolumeProperty* property)
{
  if (property->GetColorChannels() != 1)
  {
    return property->GetRGBTransferFunction();
  }
  auto color = vtkSmartPointer<vtkColorTransferFunction>::New();
  vtkPiecewiseFunction* gray = property->GetGrayTransferFunction();
  for (int i = 0; i < gray->GetSize(); ++i)
  {
    double node[4];
    gray->GetNodeValue(i, node);
    color->AddRGBPoint(node[0], node[1], node[1], node[1], node[2], node[3]);
  }
  return color;
}
}

//------------------------------------------------------------------------------
DataSpaceClassification::DataSpaceClassification() = default;

//------------------------------------------------------------------------------
DataSpaceClassification::~DataSpaceClassification() = default;

//------------------------------------------------------------------------------
bool DataSpaceClassification::Update(vtkVolumeProperty* property, const double range[2], int tableSize)
{
  const bool isCurrent = property == this->Property && property->GetMTime() == this->PropertyTime &&
    std::equal(range, range + 2, this->Range) && tableSize == this->TableSize;
  if (isCurrent)
  {
    return false;
  }
  this->Property = property;
  this->PropertyTime = property->GetMTime();
  std::copy(range, range + 2, this->Range);
  this->TableSize = tableSize;
  this->UpdateTable(property);
  this->UpdateIsosurfaces(property);
  return true;
}

//------------------------------------------------------------------------------
bool DataSpaceClassification::IsValid() const
{
  return this->Table->GetEntries() != nullptr;
}

//------------------------------------------------------------------------------
void DataSpaceClassification::UpdateTable(vtkVolumeProperty* property)
{
  this->Table->SetColorFunction(MakeColorFunction(property));
  this->Table->SetOpacityFunction(property->GetScalarOpacity());
  this->Table->SetRange(this->Range[0], this->Range[1]);
  this->Table->SetSize(this->TableSize);
  auto* optics = vtkOpticsVolumeProperty::SafeDownCast(property);
  this->Table->SetUnitInterval(optics ? optics->GetScalarOpacityUnitInterval() : 0.0);
  this->Table->Update();
}

//------------------------------------------------------------------------------
void DataSpaceClassification::UpdateIsosurfaces(vtkVolumeProperty* property)
{
  this->Isosurfaces.clear();
  auto* optics = vtkOpticsVolumeProperty::SafeDownCast(property);
  this->Silhouette = optics ? optics->GetSilhouette() : vtkOpticsVolumeProperty::SilhouetteOff;
  for (int i = 0; optics && i < optics->GetNumberOfIsosurfaces(); ++i)
  {
    glm::dvec4 color;
    const double value = optics->GetIsosurfaceValue(i);
    optics->GetIsosurfaceHasColor(i) ? optics->GetIsosurfaceColor(i, &color[0])
                                     : this->Table->GetColorFunction()->GetColor(value, &color[0]);
    color[3] = optics->GetIsosurfaceOpacity(i);
    this->Isosurfaces.push_back({ this->Normalize(value), color });
  }
  std::stable_sort(this->Isosurfaces.begin(), this->Isosurfaces.end(),
    [](const Isosurface& a, const Isosurface& b) { return a.Value < b.Value; });
}

//------------------------------------------------------------------------------
bool DataSpaceClassification::HasSilhouettes() const
{
  return this->Silhouette != vtkOpticsVolumeProperty::SilhouetteOff;
}

//------------------------------------------------------------------------------
double DataSpaceClassification::Normalize(double scalar) const
{
  return (scalar - this->Range[0]) / (this->Range[1] - this->Range[0]);
}

//------------------------------------------------------------------------------
double DataSpaceClassification::Denormalize(double scalar) const
{
  return this->Range[0] + scalar * (this->Range[1] - this->Range[0]);
}

//------------------------------------------------------------------------------
glm::dvec4 DataSpaceClassification::GetSegmentColor(double front, double back, double gradientStep) const
{
  return optics::SegmentIntegral{ *this }.SegmentColor(front, back, gradientStep);
}
