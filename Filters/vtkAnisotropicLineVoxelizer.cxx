// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnisotropicLineVoxelizer.h"

#include "Batches.h"
#include "CylinderProjection.h"
#include "LineAccumulator.h"
#include "LineInput.h"
#include "LineVoxels.h"
#include "ParameterRange.h"

#include "vtkCollection.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkAnisotropicLineVoxelizer);

using volumeoptics::LineGrid;

namespace
{
const char* const ProjectionNames[] = { "Analytic", "Sampled" };

LineGrid MakeGrid(const int dimensions[3], const volumeoptics::LineBounds& bounds)
{
  LineGrid grid;
  grid.Dimensions = { dimensions[0], dimensions[1], dimensions[2] };
  grid.Brick = glm::min(grid.Dimensions, glm::ivec3(LineGrid::LargestBrick));
  glm::dvec3 size = bounds.IsEmpty() ? glm::dvec3(1.0) : bounds.Largest - bounds.Least;
  const glm::dvec3 edges = size / glm::dvec3(grid.Dimensions);
  const double longest = std::max(std::max(edges.x, edges.y), edges.z);
  grid.Corner = bounds.IsEmpty() ? glm::dvec3(0.0) : bounds.Least;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(size[axis] > 0.0))
    {
      size[axis] = longest > 0.0 ? longest * grid.Dimensions[axis] : 1.0;
      grid.Corner[axis] -= size[axis] / 2.0;
    }
  }
  grid.Voxel = size / glm::dvec3(grid.Dimensions);
  return grid;
}
}

// What lives from the first piece to the last.
struct vtkAnisotropicLineVoxelizer::Run
{
  explicit Run(vtkAlgorithm* algorithm)
    : Batches(algorithm)
  {
  }

  bool LooksForBounds = false;
  int Piece = 0;
  volumeoptics::LineBounds Bounds;
  LineGrid Grid;
  std::vector<volumeoptics::LineLight> Lights;
  std::unique_ptr<volumeoptics::HarmonicBasis> Basis;
  std::unique_ptr<volumeoptics::LineAccumulator> Sums;
  volumeoptics::Batches Batches;
};

//------------------------------------------------------------------------------
vtkAnisotropicLineVoxelizer::vtkAnisotropicLineVoxelizer() = default;
vtkAnisotropicLineVoxelizer::~vtkAnisotropicLineVoxelizer() = default;

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
  const glm::ivec3 bricks = MakeGrid(this->SampleDimensions, {}).Bricks();
  const int extent[6] = { 0, bricks.x, 0, bricks.y, 0, bricks.z };
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnisotropicLineVoxelizer::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  input->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), this->Current ? this->Current->Piece : 0);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), this->NumberOfPieces);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::StartRun(vtkInformation* input)
{
  this->Current = std::make_unique<Run>(this);
  Run& run = *this->Current;
  const double* bounds = this->ModelBounds;
  const bool isSet = bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
  if (!isSet && input->Has(vtkDataObject::BOUNDING_BOX()))
  {
    bounds = input->Get(vtkDataObject::BOUNDING_BOX());
  }
  run.LooksForBounds = bounds == this->ModelBounds && !isSet;
  if (!run.LooksForBounds)
  {
    run.Bounds.Add({ bounds[0], bounds[2], bounds[4] });
    run.Bounds.Add({ bounds[1], bounds[3], bounds[5] });
    this->StartSums();
  }
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::StartSums()
{
  Run& run = *this->Current;
  run.LooksForBounds = false;
  run.Grid = MakeGrid(this->SampleDimensions, run.Bounds);
  run.Lights = volumeoptics::ReadLights(this->Lights);
  const bool isEven = std::all_of(run.Lights.begin(), run.Lights.end(),
    [](const volumeoptics::LineLight& light) { return light.Kind == volumeoptics::LineLight::Headlight; });
  run.Basis = std::make_unique<volumeoptics::HarmonicBasis>(this->MaximumOrder, isEven);
  volumeoptics::LineAccumulatorSettings settings;
  settings.Grid = run.Grid;
  settings.Basis = run.Basis.get();
  settings.Channels = this->ExactProduct ? 5 : 4;
  settings.CoefficientTolerance = this->CoefficientTolerance;
  run.Sums = std::make_unique<volumeoptics::LineAccumulator>(settings);
}

//------------------------------------------------------------------------------
bool vtkAnisotropicLineVoxelizer::AddTypes(const std::set<int>& types)
{
  Run& run = *this->Current;
  for (int type : types)
  {
    if (run.Sums->HasProjection(type))
    {
      continue;
    }
    volumeoptics::ProjectionSettings settings;
    settings.Basis = run.Basis.get();
    settings.Material = volumeoptics::ReadMaterial(this->GetMaterial(type),
      { this->AmbientLight[0], this->AmbientLight[1], this->AmbientLight[2] }, !this->ColorArray.empty());
    const double power = this->GetSpecularPower(type);
    settings.Material.Exponent = power >= 1.0 ? power : settings.Material.Exponent;
    settings.Lights = run.Lights;
    settings.ViewUp = { this->ViewUp[0], this->ViewUp[1], this->ViewUp[2] };
    settings.QuarterSurface = this->ExactProduct ? run.Grid.Surface() / 4.0 : 0.0;
    std::unique_ptr<volumeoptics::CylinderProjection> projection;
    if (this->Projection == Sampled)
    {
      projection =
        std::make_unique<volumeoptics::SampledProjection>(settings, this->NumberOfDirections == 128 ? 2 : 3);
    }
    else
    {
      projection = std::make_unique<volumeoptics::AnalyticProjection>(settings);
    }
    if (!projection->Prepare(
          run.Batches, run.Batches.GetProgress() + 0.05 * (1.0 - run.Batches.GetProgress())))
    {
      return false;
    }
    run.Sums->SetProjection(type, std::move(projection));
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkAnisotropicLineVoxelizer::ProgressAfterPiece(double afterAll) const
{
  const double progress = this->Current->Batches.GetProgress();
  return progress + (afterAll - progress) / (this->NumberOfPieces - this->Current->Piece);
}

//------------------------------------------------------------------------------
bool vtkAnisotropicLineVoxelizer::AddBounds(vtkPolyData* lines)
{
  const long long segmentsOfUnit = 65536;
  const volumeoptics::LineInput input(lines, {});
  const long long count = input.GetNumberOfSegments();
  std::vector<volumeoptics::LineBounds> bounds((count + segmentsOfUnit - 1) / segmentsOfUnit);
  const bool isDone = this->Current->Batches.Run(
    static_cast<long long>(bounds.size()), this->ProgressAfterPiece(0.1), [&](long long unit) {
      const long long first = unit * segmentsOfUnit;
      bounds[unit] = input.GetBounds(first, std::min(first + segmentsOfUnit, count));
    });
  for (const volumeoptics::LineBounds& part : bounds)
  {
    this->Current->Bounds.Add(part);
  }
  return isDone;
}

//------------------------------------------------------------------------------
bool vtkAnisotropicLineVoxelizer::AddPiece(vtkInformationVector** inputs)
{
  Run& run = *this->Current;
  vtkPolyData* lines = vtkPolyData::GetData(inputs[0]);
  volumeoptics::LineArrays arrays;
  arrays.Radius = this->RadiusArray;
  arrays.Type = this->LineTypeArray;
  arrays.Color = this->ColorArray;
  arrays.LookupTable = this->LookupTable;
  if (run.LooksForBounds)
  {
    if (!this->AddBounds(lines))
    {
      return false;
    }
    if (this->NumberOfPieces > 1)
    {
      return true;
    }
    this->StartSums();
  }
  arrays.ConstantRadius = this->Radius < 0.0 ? 0.1 * run.Grid.SmallestEdge() : this->Radius;
  const volumeoptics::LineInput input(lines, arrays);
  if (!input.GetMissing().empty())
  {
    vtkErrorMacro("The lines have no array " << input.GetMissing()
                                             << " of points or cells. Name one that they have, or none.");
    return false;
  }
  return this->AddTypes(input.GetTypes()) && run.Sums->Add(input, run.Batches, this->ProgressAfterPiece(0.9));
}

//------------------------------------------------------------------------------
int vtkAnisotropicLineVoxelizer::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  if (!this->Current)
  {
    this->StartRun(inputs[0]->GetInformationObject(0));
  }
  Run& run = *this->Current;
  const bool lookedForBounds = run.LooksForBounds && this->NumberOfPieces > 1;
  bool isRight = this->AddPiece(inputs) && !this->AbortExecute;
  ++run.Piece;
  if (isRight && lookedForBounds && run.Piece == this->NumberOfPieces)
  {
    this->StartSums();
    run.Piece = 0;
  }
  if (isRight && run.Piece < this->NumberOfPieces)
  {
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  if (isRight)
  {
    this->Write(output);
  }
  this->Current.reset();
  return isRight || this->AbortExecute;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::Write(vtkImageData* output)
{
  Run& run = *this->Current;
  std::vector<int> indices;
  std::vector<volumeoptics::LineTypeBricks> bricks;
  if (run.Sums->Finish(run.Batches, 1.0, indices, bricks))
  {
    volumeoptics::WriteLineVoxels(run.Grid, this->MaximumOrder, indices, bricks, run.Lights, output);
    this->Warn();
  }
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::Warn()
{
  const volumeoptics::LineFaults& faults = this->Current->Sums->GetFaults();
  if (faults.NotFinite + faults.NotPositive + faults.TooThick > 0)
  {
    vtkWarningMacro("Of the segments, "
      << faults.NotFinite
      << " have a point, radius or type that is no finite number (or a type outside [0, 255]) "
      << "and " << faults.NotPositive << " a radius of 0 or below: they are left out. " << faults.TooThick
      << " have a radius above a voxel's smallest edge, " << this->Current->Grid.SmallestEdge()
      << ": it is taken instead. Use fewer voxels for thicker lines, or draw tubes.");
  }
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
  for (const auto& material : this->Materials)
  {
    os << indent << "Material of type " << material.first << ": " << material.second.Get() << "\n";
  }
  for (const auto& power : this->SpecularPowers)
  {
    os << indent << "SpecularPower of type " << power.first << ": " << power.second << "\n";
  }
}
