// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeRepresentation.h"

#include "FloatCompositingPass.h"
#include "PieceOfVolume.h"
#include "PluginVersions.h"
#include "vtkLightingTransferFunction.h"
#include "vtkMultiSampleClassification.h"
#include "vtkOpticsMultiBlockVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVRenderView.h"
#include "vtkPartitionedDataSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"

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
bool vtkOpticsVolumeRepresentation::AddToView(vtkView* view)
{
  const bool isAdded = this->Superclass::AddToView(view);
  const std::string otherVersion = FindOtherVersion();
  if (!otherVersion.empty())
  {
    vtkWarningMacro(<< otherVersion);
  }
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (isAdded && renderView)
  {
    FloatCompositingPass::Ask(renderView->GetRenderer(), this);
  }
  return isAdded;
}

//------------------------------------------------------------------------------
// The layers only grow, so that switching models does not make readers read again and again.
int vtkOpticsVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  if (request == vtkPVView::REQUEST_UPDATE() && DrawsPieces())
  {
    this->UpdateLightingTransferFunction();
    this->UpdateMultiSampleClassification();
    const int layers = this->GetBlocks()->GetGhostLayers(this->Property);
    if (layers > this->GhostLayers)
    {
      this->GhostLayers = layers;
      this->MarkModified();
    }
  }
  return this->Superclass::ProcessViewRequest(request, input, output);
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  const bool hasInput = inputs[0]->GetNumberOfInformationObjects() > 0;
  if (DrawsPieces() && hasInput &&
    !vtkRectilinearGrid::GetData(inputs[0], 0)) // ParaView draws those of a grid
  {
    inputs[0]->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), this->GhostLayers);
  }
  return result;
}

//------------------------------------------------------------------------------
// ParaView crops the ghost layers of an image, but not of blocks, and takes the place of the piece among the others
// from what is left.
int vtkOpticsVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  if (!DrawsPieces() || inputs[0]->GetNumberOfInformationObjects() == 0)
  {
    return result;
  }
  if (vtkImageData* input = vtkImageData::GetData(inputs[0], 0))
  {
    if (input->HasAnyGhostCells())
    {
      vtkSmartPointer<vtkImageData> piece = KeepGhostLayers(input);
      if (this->UseSeparateOpacityArray)
      {
        this->AppendOpacityComponent(piece);
      }
      this->Cache = piece;
    }
  }
  else if (auto* blocks = vtkPartitionedDataSet::SafeDownCast(this->Cache))
  {
    KeepGhostLayersOfBlocks(blocks).GetBounds(this->DataBounds);
    this->OutlineSource->SetBounds(this->DataBounds);
    this->OutlineSource->Update();
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseLightingTransferFunction: " << this->Light->IsUsed << "\n";
  os << indent << "LightingFile: " << this->Light->File << "\n";
  os << indent << "Lighting boundaries: " << this->Light->Boundaries.size() << "\n";
  os << indent << "GhostLayers: " << this->GhostLayers << "\n";
  os << indent << "MultiSampleFile: " << this->Light->RulesFile << "\n";
}
