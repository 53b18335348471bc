// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeRepresentation.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkLightingTransferFunction.h"
#include "vtkMultiSampleClassification.h"
#include "vtkOpticsMultiBlockVolumeMapper.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <array>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkOpticsVolumeRepresentation);

namespace
{
using Mapper = vtkOpticsVolumeMapper;
using Property = vtkOpticsVolumeProperty;

struct Boundary
{
  double A[2];
  double B[2];
  double Softness;
  double Ambient, Diffuse, Specular;
};
}

struct vtkOpticsVolumeRepresentation::Lighting
{
  bool IsUsed = false;
  bool IsModified = false;
  std::vector<Boundary> Boundaries;
  std::string File;
  std::string RulesFile;
  bool RulesAreModified = false;
};

//------------------------------------------------------------------------------
vtkOpticsVolumeRepresentation::vtkOpticsVolumeRepresentation()
  : Light(new Lighting)
{
  this->VolumeMapper = vtkSmartPointer<vtkOpticsMultiBlockVolumeMapper>::New();
}

//------------------------------------------------------------------------------
vtkOpticsVolumeRepresentation::~vtkOpticsVolumeRepresentation() = default;

//------------------------------------------------------------------------------
vtkOpticsMultiBlockVolumeMapper* vtkOpticsVolumeRepresentation::GetBlocks()
{
  return static_cast<vtkOpticsMultiBlockVolumeMapper*>(this->VolumeMapper.Get());
}

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty* vtkOpticsVolumeRepresentation::GetOptics()
{
  return this->GetBlocks()->GetOptics();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetReflectanceModel(int model)
{
  this->GetOptics()->SetReflectanceModel(model);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetBlinnPhongExponent(double exponent)
{
  this->GetOptics()->SetGlossiness(Property::BlinnPhong, exponent);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetWardRoughness(double roughness)
{
  this->GetOptics()->SetGlossiness(Property::Ward, roughness);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLafortuneExponent(double exponent)
{
  this->GetOptics()->SetGlossiness(Property::Lafortune, exponent);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetWardAnisotropyScale(double scale)
{
  this->GetOptics()->SetAnisotropyScale(Property::Ward, scale);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLafortuneAnisotropyScale(double scale)
{
  this->GetOptics()->SetAnisotropyScale(Property::Lafortune, scale);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetSpecularFromExtinction(bool on)
{
  this->GetOptics()->SetSpecularFromExtinction(on);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetFrameSource(int source)
{
  this->GetOptics()->SetFrameSource(source);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetPhaseAnisotropy(double anisotropy)
{
  this->GetOptics()->SetScatteringAnisotropy(static_cast<float>(anisotropy));
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetIntegrationSpace(int space)
{
  this->GetOptics()->SetIntegrationSpace(space);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetClassification(int classification)
{
  this->GetOptics()->SetClassification(classification);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetScalarOpacityUnitInterval(double interval)
{
  this->GetOptics()->SetScalarOpacityUnitInterval(interval);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetSilhouette(int silhouette)
{
  this->GetOptics()->SetSilhouette(silhouette);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetTransmittedLight(int light)
{
  this->GetOptics()->SetTransmittedLight(light);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::RemoveAllOpticsIsosurfaces()
{
  this->GetOptics()->RemoveAllIsosurfaces();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::AddOpticsIsosurface(double value, double opacity)
{
  this->GetOptics()->AddIsosurface(value, opacity);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetUseLightingTransferFunction(bool use)
{
  this->Light->IsUsed = use;
  this->Light->IsModified = true;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::RemoveAllLightingBoundaries()
{
  this->Light->Boundaries.clear();
  this->Light->IsModified = true;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::AddLightingBoundary(double lowA, double highA, double lowB, double highB,
  double softness, double ambient, double diffuse, double specular)
{
  this->Light->Boundaries.push_back(
    { { lowA, highA }, { lowB, highB }, softness, ambient, diffuse, specular });
  this->Light->IsModified = true;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLightingFile(const char* name)
{
  this->Light->File = name ? name : "";
  this->Light->IsModified = true;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetMultiSampleFile(const char* name)
{
  this->Light->RulesFile = name ? name : "";
  this->Light->RulesAreModified = true;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetGradientStepLength(double length)
{
  this->GetOptics()->SetGradientStepLength(length);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLightScale(double scale)
{
  this->GetOptics()->SetLightScale(scale);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetHybridNormals(bool on)
{
  this->GetOptics()->SetHybridNormals(on);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetQuality(int quality)
{
  this->GetBlocks()->SetQuality(quality);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetFrameResolutionFactor(double factor)
{
  this->GetBlocks()->SetPresetKnob(
    "FrameResolutionFactor", [=](Mapper* mapper) { mapper->SetFrameResolutionFactor(factor); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetFramePrecision(int bits)
{
  this->GetBlocks()->SetPresetKnob(
    "FramePrecision", [=](Mapper* mapper) { mapper->SetFramePrecision(bits); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceSamples(int samples)
{
  this->GetBlocks()->SetPresetKnob("CovarianceSamples",
    [=](Mapper* mapper) { mapper->GetAmbientCovarianceFilter()->SetNumberOfSamples(samples); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceSmoothing(double standardDeviation)
{
  this->GetBlocks()->SetPresetKnob("CovarianceSmoothing", [=](Mapper* mapper) {
    mapper->GetAmbientCovarianceFilter()->SetFilterStandardDeviation(standardDeviation);
  });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceRadius(double radius)
{
  this->GetBlocks()->SetKnob(
    "CovarianceRadius", [=](Mapper* mapper) { mapper->GetAmbientCovarianceFilter()->SetRadius(radius); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceTolerance(double tolerance)
{
  this->GetBlocks()->SetKnob("CovarianceTolerance",
    [=](Mapper* mapper) { mapper->GetAmbientCovarianceFilter()->SetScalarTolerance(tolerance); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetExtinctionGradient(int gradient)
{
  this->GetBlocks()->SetKnob(
    "ExtinctionGradient", [=](Mapper* mapper) { mapper->SetExtinctionGradient(gradient); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetScalarGradient(int gradient)
{
  this->GetBlocks()->SetKnob("ScalarGradient", [=](Mapper* mapper) { mapper->SetScalarGradient(gradient); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLightingSamples(int samples)
{
  this->GetBlocks()->SetKnob("LightingSamples", [=](Mapper* mapper) { mapper->SetLightingSamples(samples); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLightingTableSize(int size)
{
  this->GetBlocks()->SetKnob(
    "LightingTableSize", [=](Mapper* mapper) { mapper->SetLightingTableSize(size); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetPreIntegrationTableSize(int size)
{
  this->GetBlocks()->SetKnob(
    "PreIntegrationTableSize", [=](Mapper* mapper) { mapper->SetPreIntegrationTableSize(size); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetTablePrecision(int bits)
{
  this->GetBlocks()->SetKnob("TablePrecision", [=](Mapper* mapper) { mapper->SetTablePrecision(bits); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::UpdateLightingTransferFunction()
{
  if (!this->Light->IsModified)
  {
    return;
  }
  this->Light->IsModified = false;
  vtkNew<vtkLightingTransferFunction> function;
  if (!this->Light->File.empty())
  {
    function->ReadJson(this->Light->File.c_str());
  }
  for (const Boundary& boundary : this->Light->Boundaries)
  {
    const int index =
      function->AddBoundary(boundary.A, boundary.B, boundary.Ambient, boundary.Diffuse, boundary.Specular);
    if (index >= 0)
    {
      function->SetSoftness(index, boundary.Softness);
    }
  }
  const bool isUsed =
    this->Light->IsUsed && (function->GetNumberOfBoundaries() > 0 || function->GetTableImage());
  this->GetOptics()->SetLightingTransferFunction(isUsed ? function.Get() : nullptr);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::UpdateMultiSampleClassification()
{
  if (!this->Light->RulesAreModified)
  {
    return;
  }
  this->Light->RulesAreModified = false;
  vtkNew<vtkMultiSampleClassification> rules;
  const bool isRead = !this->Light->RulesFile.empty() && rules->ReadJson(this->Light->RulesFile.c_str());
  this->GetOptics()->SetMultiSampleClassification(isRead ? rules.Get() : nullptr);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  const bool hasArray =
    this->UseTransfer2D && !this->UseGradientForTransfer2D && !this->ColorArray2Name.empty();
  this->GetBlocks()->SetTransfer2DYAxisArray(hasArray ? this->ColorArray2Name.c_str() : nullptr);
  this->UpdateLightingTransferFunction();
  this->UpdateMultiSampleClassification();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseLightingTransferFunction: " << this->Light->IsUsed << "\n";
  os << indent << "LightingFile: " << this->Light->File << "\n";
  os << indent << "Lighting boundaries: " << this->Light->Boundaries.size() << "\n";
  os << indent << "MultiSampleFile: " << this->Light->RulesFile << "\n";
}
