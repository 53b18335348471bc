// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnisotropicLineVoxelizer.h"

#include "LineVoxelizerRun.h"
#include "ParameterRange.h"

#include "vtkCollection.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkAnisotropicLineVoxelizer);

namespace
{
const char* const ProjectionNames[] = { "Analytic", "Sampled" };
}

//------------------------------------------------------------------------------
vtkAnisotropicLineVoxelizer::vtkAnisotropicLineVoxelizer()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkAnisotropicLineVoxelizer::~vtkAnisotropicLineVoxelizer() = default;

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkAnisotropicLineVoxelizer::GetController() const
{
  return this->Controller;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetSampleDimensions(int x, int y, int z)
{
  const int wanted[3] = { x, y, z };
  for (int axis = 0; axis < 3; ++axis)
  {
    volumeoptics::SetWithinRange(
      this, "SampleDimensions", wanted[axis], 1, 4096, this->SampleDimensions[axis]);
  }
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetName(std::string& array, const char* name)
{
  const std::string wanted = name ? name : "";
  if (wanted != array)
  {
    array = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetLookupTable(vtkScalarsToColors* table)
{
  if (this->LookupTable != table)
  {
    this->LookupTable = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkAnisotropicLineVoxelizer::GetLookupTable() const
{
  return this->LookupTable;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetMaterial(int type, vtkProperty* material)
{
  if (type < 0 || type > 255)
  {
    vtkWarningMacro("Line type " << type << " is outside its range [0, 255]; its material is not kept.");
    return;
  }
  this->Materials[type] = material;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkProperty* vtkAnisotropicLineVoxelizer::GetMaterial(int type) const
{
  const auto found = this->Materials.find(type);
  return found == this->Materials.end() ? nullptr : found->second.Get();
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetSpecularPower(int type, double power)
{
  double wanted = this->GetSpecularPower(type);
  volumeoptics::SetWithinRange(this, "SpecularPower", power, 0.0, 1000.0, wanted);
  this->SpecularPowers[type] = wanted;
}

//------------------------------------------------------------------------------
double vtkAnisotropicLineVoxelizer::GetSpecularPower(int type) const
{
  const auto found = this->SpecularPowers.find(type);
  return found == this->SpecularPowers.end() ? 0.0 : found->second;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetMaximumOrder(int order)
{
  volumeoptics::SetWithinRange(
    this, "MaximumOrder", order, 0, volumeoptics::HarmonicBasis::LargestOrder, this->MaximumOrder);
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetLights(vtkLightCollection* lights)
{
  if (this->Lights != lights)
  {
    this->Lights = lights;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLightCollection* vtkAnisotropicLineVoxelizer::GetLights() const
{
  return this->Lights;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetCoefficientTolerance(double tolerance)
{
  volumeoptics::SetWithinRange(this, "CoefficientTolerance", tolerance, 0.0, 1.0, this->CoefficientTolerance);
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetProjection(int projection)
{
  volumeoptics::SetChoice(this, "Projection", projection, ProjectionNames, this->Projection);
}

//------------------------------------------------------------------------------
const char* vtkAnisotropicLineVoxelizer::GetProjectionAsString() const
{
  return ProjectionNames[this->Projection];
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetNumberOfDirections(int directions)
{
  if (directions != 128 && directions != 512)
  {
    vtkWarningMacro("NumberOfDirections " << directions << " is none of 128, 512; it stays "
                                          << this->NumberOfDirections << ".");
    return;
  }
  if (directions != this->NumberOfDirections)
  {
    this->NumberOfDirections = directions;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::SetNumberOfPieces(int pieces)
{
  volumeoptics::SetWithinRange(this, "NumberOfPieces", pieces, 1, VTK_INT_MAX, this->NumberOfPieces);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAnisotropicLineVoxelizer::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  const auto include = [&](vtkObject* object) { time = object ? std::max(time, object->GetMTime()) : time; };
  include(this->LookupTable);
  include(this->Lights);
  for (const auto& material : this->Materials)
  {
    include(material.second);
  }
  if (this->Lights)
  {
    vtkCollectionSimpleIterator iterator;
    this->Lights->InitTraversal(iterator);
    while (vtkLight* light = this->Lights->GetNextLight(iterator))
    {
      include(light);
    }
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkAnisotropicLineVoxelizer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnisotropicLineVoxelizer::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->Current.reset(); // of a run that the source did not let end
  const glm::ivec3 bricks = volumeoptics::MakeLineGrid(this->SampleDimensions, {}).Bricks();
  const int extent[6] = { 0, bricks.x, 0, bricks.y, 0, bricks.z };
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnisotropicLineVoxelizer::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  const volumeoptics::ProcessGroup processes(this->Controller, this, outputs->GetInformationObject(0));
  const int piece = this->Current ? this->Current->Piece : 0;
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(),
    processes.GetRank() * this->NumberOfPieces + piece);
  input->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), processes.GetSize() * this->NumberOfPieces);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnisotropicLineVoxelizer::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  if (!this->Current)
  {
    this->StartRun(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  }
  Run& run = *this->Current;
  bool isRight = this->AddPiece(inputs) && !this->AbortExecute;
  ++run.Piece;
  if (run.LooksForBounds && !run.HasFailed && (!isRight || run.Piece == this->NumberOfPieces))
  {
    isRight = this->AgreeOnBounds(isRight);
    run.Piece = 0;
  }
  if (isRight && run.Piece < this->NumberOfPieces)
  {
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  isRight = this->Write(isRight, output);
  this->Current.reset();
  return isRight || this->AbortExecute;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto* numbers, int count) {
    os << indent << name << ":";
    for (int i = 0; i < count; ++i)
    {
      os << " " << numbers[i];
    }
    os << "\n";
  };
  print("SampleDimensions", this->SampleDimensions, 3);
  print("ModelBounds", this->ModelBounds, 6);
  print("AmbientLight", this->AmbientLight, 3);
  print("ViewUp", this->ViewUp, 3);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusArray: " << this->RadiusArray << "\n";
  os << indent << "LineTypeArray: " << this->LineTypeArray << "\n";
  os << indent << "ColorArray: " << this->ColorArray << "\n";
  os << indent << "LookupTable: " << this->LookupTable.Get() << "\n";
  os << indent << "Lights: " << this->Lights.Get() << "\n";
  os << indent << "MaximumOrder: " << this->MaximumOrder << "\n";
  os << indent << "CoefficientTolerance: " << this->CoefficientTolerance << "\n";
  os << indent << "Projection: " << this->GetProjectionAsString() << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "ExactProduct: " << this->ExactProduct << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "ResultOnAllProcesses: " << this->ResultOnAllProcesses << "\n";
  for (const auto& material : this->Materials)
  {
    os << indent << "Material of type " << material.first << ": " << material.second.Get() << "\n";
  }
  for (const auto& power : this->SpecularPowers)
  {
    os << indent << "SpecularPower of type " << power.first << ": " << power.second << "\n";
  }
}
