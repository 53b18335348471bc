// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnisotropicVoxelEvaluator.h"

#include "Batches.h"
#include "HarmonicBasis.h"
#include "LineVoxels.h"
#include "ParameterRange.h"
#include "VoxelEvaluation.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkAnisotropicVoxelEvaluator);

using volumeoptics::LineGrid;
using volumeoptics::LineVoxels;

namespace
{
const char* const ViewDirectionsNames[] = { "PerVoxel", "PerBlock" };

double LargestOf(int scalarType)
{
  return scalarType == VTK_UNSIGNED_CHAR ? 255.0 : scalarType == VTK_UNSIGNED_SHORT ? 65535.0 : 1.0;
}

class View
{
public:
  explicit View(vtkCamera* camera)
    : IsParallel(camera->GetParallelProjection())
  {
    camera->GetPosition(&this->Position.x);
    double direction[3];
    camera->GetDirectionOfProjection(direction);
    this->Direction = -glm::dvec3(direction[0], direction[1], direction[2]);
  }

  glm::dvec3 From(const glm::dvec3& point) const
  {
    const glm::dvec3 way = this->Position - point;
    const double length = glm::length(way);
    return this->IsParallel || !(length > 0.0) ? this->Direction : way / length;
  }

private:
  bool IsParallel;
  glm::dvec3 Position, Direction;
};

// What an evaluation needs, and its result.
template <class Scalar>
class Evaluation
{
public:
  Evaluation(const LineVoxels& voxels, const View& view, bool perVoxel, vtkImageData* output)
    : Voxels(voxels)
    , Basis(voxels.MaximumOrder, false)
    , Eye(view)
    , PerVoxel(perVoxel)
    , Largest(LargestOf(output->GetScalarType()))
    , Scalars(static_cast<Scalar*>(output->GetScalarPointer()))
  {
  }

  std::vector<volumeoptics::LineScale> Scales;
  vtkPiecewiseFunction* Function = nullptr;

  void EvaluateBrick(long long brick)
  {
    const int index = this->Voxels.BrickIndices[brick];
    const LineGrid& grid = this->Voxels.Grid;
    if (index < 0)
    {
      return;
    }
    double basis[volumeoptics::HarmonicBasis::LargestCount];
    const glm::dvec3 middle =
      grid.CenterOf(grid.FirstVoxelOf(brick)) + 0.5 * (glm::dvec3(grid.Brick) - 1.0) * grid.Voxel;
    this->Basis.Evaluate(this->Eye.From(middle), basis);
    std::vector<vtkTypeInt64> next, end;
    for (const volumeoptics::LineCoefficients& set : this->Voxels.Types)
    {
      next.push_back(set.BrickStarts[index]);
      end.push_back(set.BrickStarts[index + 1]);
    }
    for (int place = 0; place < grid.VoxelsOfBrick(); ++place)
    {
      const glm::ivec3 voxel = grid.VoxelAt(brick, place);
      if (glm::any(glm::greaterThanEqual(voxel, grid.Dimensions)))
      {
        continue;
      }
      if (this->PerVoxel)
      {
        this->Basis.Evaluate(this->Eye.From(grid.CenterOf(voxel)), basis);
      }
      this->EvaluateVoxel(place, next, end, basis, this->At(voxel));
    }
  }

  // The most opaque voxel becomes opaque.
  void MarkOpacityRange()
  {
    const glm::ivec3 size = this->Voxels.Grid.Dimensions;
    const long long count = static_cast<long long>(size.x) * size.y * size.z;
    Scalar* most = this->Scalars;
    for (long long i = 1; i < count; ++i)
    {
      Scalar* rgba = this->Scalars + 4 * i;
      most = rgba[3] > most[3] ? rgba : most;
    }
    if (most[3] > 0)
    {
      most[3] = static_cast<Scalar>(this->Largest);
    }
  }

  // Gives the empty voxels of the brick the mean colour of their neighbours, weighted by opacity.
  void SpreadBrick(long long brick)
  {
    const LineGrid& grid = this->Voxels.Grid;
    for (int place = 0; this->HasOccupiedAround(brick) && place < grid.VoxelsOfBrick(); ++place)
    {
      const glm::ivec3 voxel = grid.VoxelAt(brick, place);
      if (glm::all(glm::lessThan(voxel, grid.Dimensions)) && this->At(voxel)[3] == 0)
      {
        this->SpreadInto(voxel);
      }
    }
  }

private:
  Scalar* At(const glm::ivec3& voxel) const
  {
    const glm::ivec3 size = this->Voxels.Grid.Dimensions;
    return this->Scalars +
      4 * (voxel.x + static_cast<long long>(size.x) * (voxel.y + static_cast<long long>(size.y) * voxel.z));
  }

  Scalar ToScalar(double value) const
  {
    const double scaled = std::clamp(value, 0.0, 1.0) * this->Largest;
    return static_cast<Scalar>(this->Largest > 1.0 ? std::round(scaled) : scaled);
  }

  void EvaluateVoxel(int place, std::vector<vtkTypeInt64>& next, const std::vector<vtkTypeInt64>& end,
    const double* basis, Scalar* rgba) const
  {
    glm::dvec3 color(0.0);
    double depth = 0.0;
    for (std::size_t t = 0; t < next.size(); ++t)
    {
      const volumeoptics::LineCoefficients& set = this->Voxels.Types[t];
      if (next[t] < end[t] && set.Places[next[t]] == place)
      {
        const auto part = volumeoptics::EvaluateVoxel(set, next[t]++, basis, this->Scales[t]);
        color += part.Depth * part.Color;
        depth += part.Depth;
      }
    }
    if (depth > 0.0)
    {
      const double opacity = 1.0 - std::exp(-depth);
      for (int c = 0; c < 3; ++c)
      {
        rgba[c] = this->ToScalar(color[c] / depth);
      }
      rgba[3] = this->ToScalar(this->Function ? this->Function->GetValue(opacity) : opacity);
    }
  }

  bool HasOccupiedAround(long long brick) const
  {
    bool isOccupied = false;
    this->ForEachNeighbour(this->Voxels.Grid.FirstVoxelOf(brick) / this->Voxels.Grid.Brick,
      this->Voxels.Grid.Bricks(), [&](const glm::ivec3& other) {
        const long long number = this->Voxels.Grid.BrickOf(other * this->Voxels.Grid.Brick);
        isOccupied = isOccupied || this->Voxels.BrickIndices[number] >= 0;
      });
    return isOccupied;
  }

  void SpreadInto(const glm::ivec3& voxel) const
  {
    glm::dvec3 sum(0.0);
    double weight = 0.0;
    this->ForEachNeighbour(voxel, this->Voxels.Grid.Dimensions, [&](const glm::ivec3& other) {
      const Scalar* rgba = this->At(other);
      const double opacity = rgba[3];
      sum += opacity * glm::dvec3(rgba[0], rgba[1], rgba[2]);
      weight += opacity;
    });
    for (int c = 0; c < 3 && weight > 0.0; ++c)
    {
      this->At(voxel)[c] = this->ToScalar(sum[c] / weight / this->Largest);
    }
  }

  template <class Visit>
  static void ForEachNeighbour(const glm::ivec3& place, const glm::ivec3& size, const Visit& visit)
  {
    const glm::ivec3 first = glm::max(place - 1, glm::ivec3(0)), last = glm::min(place + 1, size - 1);
    for (int z = first.z; z <= last.z; ++z)
    {
      for (int y = first.y; y <= last.y; ++y)
      {
        for (int x = first.x; x <= last.x; ++x)
        {
          visit(glm::ivec3(x, y, z));
        }
      }
    }
  }

  const LineVoxels& Voxels;
  volumeoptics::HarmonicBasis Basis;
  const View& Eye;
  bool PerVoxel;
  double Largest;
  Scalar* Scalars;
};

template <class Scalar>
bool RunEvaluation(Evaluation<Scalar> evaluation, const std::vector<volumeoptics::LineScale>& scales,
  vtkPiecewiseFunction* function, bool marksRange, long long bricks, volumeoptics::Batches& batches)
{
  evaluation.Scales = scales;
  evaluation.Function = function;
  const bool isDone = batches.Run(bricks, 0.7, [&](long long brick) { evaluation.EvaluateBrick(brick); }) &&
    batches.Run(bricks, 1.0, [&](long long brick) { evaluation.SpreadBrick(brick); });
  if (isDone && marksRange)
  {
    evaluation.MarkOpacityRange();
  }
  return isDone;
}
}

//------------------------------------------------------------------------------
vtkAnisotropicVoxelEvaluator::vtkAnisotropicVoxelEvaluator() = default;
vtkAnisotropicVoxelEvaluator::~vtkAnisotropicVoxelEvaluator() = default;

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkAnisotropicVoxelEvaluator::GetCamera() const
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetViewDirections(int directions)
{
  volumeoptics::SetChoice(this, "ViewDirections", directions, ViewDirectionsNames, this->ViewDirections);
}

//------------------------------------------------------------------------------
const char* vtkAnisotropicVoxelEvaluator::GetViewDirectionsAsString() const
{
  return ViewDirectionsNames[this->ViewDirections];
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetScale(
  std::map<int, double>& scales, const char* name, int type, double scale, double largest)
{
  const auto place = scales.emplace(type, 1.0).first;
  volumeoptics::SetWithinRange(this, name, scale, 0.0, largest, place->second);
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetRadiusScale(int type, double scale)
{
  this->SetScale(this->RadiusScales, "RadiusScale", type, scale, 1.0e6);
}

//------------------------------------------------------------------------------
double vtkAnisotropicVoxelEvaluator::GetRadiusScale(int type) const
{
  const auto found = this->RadiusScales.find(type);
  return found == this->RadiusScales.end() ? 1.0 : found->second;
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetOpacityScale(int type, double scale)
{
  this->SetScale(this->OpacityScales, "OpacityScale", type, scale, 1.0);
}

//------------------------------------------------------------------------------
double vtkAnisotropicVoxelEvaluator::GetOpacityScale(int type) const
{
  const auto found = this->OpacityScales.find(type);
  return found == this->OpacityScales.end() ? 1.0 : found->second;
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetOpacityFunction(vtkPiecewiseFunction* function)
{
  if (this->OpacityFunction != function)
  {
    this->OpacityFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkAnisotropicVoxelEvaluator::GetOpacityFunction() const
{
  return this->OpacityFunction;
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetOutputScalarType(int type)
{
  if (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT && type != VTK_FLOAT)
  {
    vtkWarningMacro("OutputScalarType " << type
                                        << " is none of VTK_UNSIGNED_CHAR (3), VTK_UNSIGNED_SHORT (5), "
                                        << "VTK_FLOAT (10); it stays " << this->OutputScalarType << ".");
    return;
  }
  if (type != this->OutputScalarType)
  {
    this->OutputScalarType = type;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkAnisotropicVoxelEvaluator::GetScalarOpacityUnitDistance(vtkImageData* voxels)
{
  std::string error = "none";
  if (voxels)
  {
    const LineVoxels lines(voxels, error);
    if (error.empty())
    {
      return 4.0 * lines.Grid.Volume() / lines.Grid.Surface();
    }
  }
  return 0.0;
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetUpVolume(vtkVolume* volume)
{
  if (this->GetNumberOfInputConnections(0) == 0 || !volume)
  {
    vtkErrorMacro("There is no input or no volume. Connect the voxels first, and give a vtkVolume.");
    return;
  }
  vtkAlgorithmOutput* input = this->GetInputConnection(0, 0);
  input->GetProducer()->Update(input->GetIndex());
  const double distance =
    GetScalarOpacityUnitDistance(vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0)));
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(LargestOf(this->OutputScalarType), 1.0);
  vtkVolumeProperty* property = volume->GetProperty();
  property->IndependentComponentsOff();
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  property->SetScalarOpacity(opacity);
  for (int component = 0; component < 4; ++component) // VTK takes that of the opacity's component
  {
    property->SetScalarOpacityUnitDistance(component, distance > 0.0 ? distance : 1.0);
  }
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  if (mapper)
  {
    mapper->SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper::NATIVE);
  }
  this->SetMarkOpacityRange(mapper == nullptr);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAnisotropicVoxelEvaluator::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->Camera ? std::max(time, this->Camera->GetMTime()) : time;
  return this->OpacityFunction ? std::max(time, this->OpacityFunction->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkAnisotropicVoxelEvaluator::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // the size of the grid stands in the data
  this->GetInputAlgorithm(0, 0)->Update(this->GetInputConnection(0, 0)->GetIndex());
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  std::string error;
  const LineVoxels voxels(input, error);
  if (!error.empty())
  {
    vtkErrorMacro("The input holds " << error << ". Connect the output of vtkAnisotropicLineVoxelizer.");
    return 0;
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  const glm::ivec3 size = voxels.Grid.Dimensions;
  const int extent[6] = { 0, size.x - 1, 0, size.y - 1, 0, size.z - 1 };
  const glm::dvec3 origin = voxels.Grid.CenterOf(glm::ivec3(0));
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), &origin.x, 3);
  info->Set(vtkDataObject::SPACING(), &voxels.Grid.Voxel.x, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, this->OutputScalarType, 4);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnisotropicVoxelEvaluator::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  int extent[6];
  input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnisotropicVoxelEvaluator::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  std::string error;
  const LineVoxels voxels(vtkImageData::GetData(inputs[0]), error);
  if (!error.empty() || !this->Camera)
  {
    vtkErrorMacro(<< (error.empty() ? "There is no camera. Set one with SetCamera()."
                                    : "The input holds " + error + "."));
    return 0;
  }
  const glm::dvec3 origin = voxels.Grid.CenterOf(glm::ivec3(0));
  output->SetDimensions(&voxels.Grid.Dimensions.x);
  output->SetOrigin(&origin.x);
  output->SetSpacing(&voxels.Grid.Voxel.x);
  output->AllocateScalars(this->OutputScalarType, 4);
  vtkDataArray* scalars = output->GetPointData()->GetScalars();
  scalars->SetName("RGBA");
  std::fill_n(static_cast<char*>(scalars->GetVoidPointer(0)),
    scalars->GetNumberOfValues() * scalars->GetDataTypeSize(), 0);
  std::vector<volumeoptics::LineScale> scales;
  for (const volumeoptics::LineCoefficients& set : voxels.Types)
  {
    scales.push_back({ this->GetRadiusScale(set.Type), this->GetOpacityScale(set.Type) });
  }
  const View view(this->Camera);
  const bool perVoxel = this->ViewDirections == PerVoxel && !this->Camera->GetParallelProjection();
  volumeoptics::Batches batches(this);
  const auto run = [&](auto zero) {
    return RunEvaluation(Evaluation<decltype(zero)>(voxels, view, perVoxel, output), scales,
      this->OpacityFunction, this->MarkOpacityRange, voxels.Grid.NumberOfBricks(), batches);
  };
  const bool isDone = this->OutputScalarType == VTK_UNSIGNED_CHAR ? run(static_cast<unsigned char>(0))
    : this->OutputScalarType == VTK_UNSIGNED_SHORT                ? run(static_cast<unsigned short>(0))
                                                                  : run(0.0F);
  if (!isDone)
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ViewDirections: " << this->GetViewDirectionsAsString() << "\n";
  os << indent << "OpacityFunction: " << this->OpacityFunction.Get() << "\n";
  os << indent << "MarkOpacityRange: " << this->MarkOpacityRange << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
  for (const auto& scale : this->RadiusScales)
  {
    os << indent << "RadiusScale of type " << scale.first << ": " << scale.second << "\n";
  }
  for (const auto& scale : this->OpacityScales)
  {
    os << indent << "OpacityScale of type " << scale.first << ": " << scale.second << "\n";
  }
}
