// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeRepresentation.h"

#include "vtkLightingTransferFunction.h"
#include "vtkMultiSampleClassification.h"
#include "vtkOpticsMultiBlockVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <array>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkOpticsVolumeRepresentation);

namespace
{
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
  this->GetBlocks()->SetWholeExtent(this->WholeExtent);
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
