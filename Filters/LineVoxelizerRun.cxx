// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineVoxelizerRun.h"

#include "CylinderProjection.h"
#include "LineInput.h"
#include "LineVoxels.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLightCollection.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

namespace volumeoptics
{
LineGrid MakeLineGrid(const int dimensions[3], const LineBounds& bounds)
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

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::StartRun(vtkInformation* input, vtkInformation* output)
{
  this->Current = std::make_unique<Run>(this, volumeoptics::ProcessGroup(this->Controller, this, output));
  Run& run = *this->Current;
  const double* bounds = this->ModelBounds;
  const bool isSet = bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
  const bool isNamed = !isSet && run.Processes.All(input->Has(vtkDataObject::BOUNDING_BOX()));
  if (isNamed)
  {
    bounds = input->Get(vtkDataObject::BOUNDING_BOX());
  }
  run.LooksForBounds = !isSet && !isNamed;
  if (!run.LooksForBounds)
  {
    run.Bounds.Add({ bounds[0], bounds[2], bounds[4] });
    run.Bounds.Add({ bounds[1], bounds[3], bounds[5] });
    this->AgreeOnBounds(true);
  }
}

//------------------------------------------------------------------------------
// The box of all processes' lines; if a process has failed, all stop.
bool vtkAnisotropicLineVoxelizer::AgreeOnBounds(bool isRight)
{
  Run& run = *this->Current;
  run.Processes.Least(&run.Bounds.Least.x, 3);
  run.Processes.Largest(&run.Bounds.Largest.x, 3);
  run.HasFailed = !this->AllAreRight(isRight);
  if (!run.HasFailed)
  {
    this->StartSums();
  }
  return !run.HasFailed;
}

//------------------------------------------------------------------------------
bool vtkAnisotropicLineVoxelizer::AllAreRight(bool isRight)
{
  const bool areRight = this->Current->Processes.All(isRight);
  if (isRight && !areRight)
  {
    vtkErrorMacro("Another process has no voxels of its lines. Look at its messages.");
  }
  return areRight;
}

//------------------------------------------------------------------------------
void vtkAnisotropicLineVoxelizer::StartSums()
{
  Run& run = *this->Current;
  run.LooksForBounds = false;
  run.Grid = volumeoptics::MakeLineGrid(this->SampleDimensions, run.Bounds);
  run.Lights = volumeoptics::ReadLights(this->Lights);
  const bool isEven = std::all_of(run.Lights.begin(), run.Lights.end(),
    [](const volumeoptics::LineLight& light) { return light.Kind == volumeoptics::LineLight::Headlight; });
  run.Basis = std::make_unique<volumeoptics::HarmonicBasis>(this->MaximumOrder, isEven);
  volumeoptics::LineAccumulatorSettings settings;
  settings.Grid = run.Grid;
  settings.Basis = run.Basis.get();
  settings.OnAllProcesses = this->ResultOnAllProcesses;
  settings.ExactProduct = this->ExactProduct;
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
    const bool isDone = this->AddBounds(lines);
    if (this->NumberOfPieces > 1)
    {
      return isDone;
    }
    if (!this->AgreeOnBounds(isDone))
    {
      return false;
    }
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
// The types of all processes, which then have the same sets.
bool vtkAnisotropicLineVoxelizer::ShareTypes()
{
  Run& run = *this->Current;
  std::vector<unsigned char> occurs(256, 0);
  for (int type : run.Sums->GetTypes())
  {
    occurs[type] = 1;
  }
  run.Processes.Largest(occurs);
  std::set<int> types;
  for (int type = 0; type < 256; ++type)
  {
    if (occurs[type])
    {
      types.insert(type);
    }
  }
  return this->AddTypes(types);
}

//------------------------------------------------------------------------------
bool vtkAnisotropicLineVoxelizer::Write(bool isRight, vtkImageData* output)
{
  Run& run = *this->Current;
  if (run.HasFailed)
  {
    return false;
  }
  isRight = this->ShareTypes() && isRight;
  std::vector<int> indices;
  std::vector<volumeoptics::LineTypeBricks> bricks;
  if (!this->AllAreRight(isRight))
  {
    return false;
  }
  const bool isDone = run.Sums->Finish(run.Batches, 1.0, run.Processes, indices, bricks);
  if (isDone && (this->ResultOnAllProcesses || run.Processes.GetRank() == 0))
  {
    volumeoptics::WriteLineVoxels(run.Grid, this->MaximumOrder, indices, bricks, run.Lights, output);
  }
  if (isDone)
  {
    this->Warn();
  }
  return true;
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
