// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnisotropicVoxelEvaluator.h"

#include "Batches.h"
#include "BlockCropping.h"
#include "LineVoxels.h"
#include "ParameterRange.h"
#include "VoxelImage.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkAnisotropicVoxelEvaluator);

using volumeoptics::LineVoxels;

namespace
{
// VTK's table of opacities has as many entries as the least distance of two points asks for, and is looked up half an
// entry too low, which takes light off thin lines. A little less than what every OpenGL has room for.
const double OpacityTableEntries = 8000.0;

const char* const ViewDirectionsNames[] = { "PerVoxel", "PerBlock" };

// VTK's mapper on the CPU draws four components of bytes alone.
bool DrawsOnCPU(vtkAbstractVolumeMapper* mapper)
{
  auto* smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  return vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper) ||
    (smart && smart->GetRequestedRenderMode() == vtkSmartVolumeMapper::RayCastRenderMode);
}

void SetUpProperty(vtkVolumeProperty* property, double largestScalar, double unitDistance)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const double value : { 0.0, 1.0 / OpacityTableEntries, 1.0 })
  {
    opacity->AddPoint(value * largestScalar, value);
  }
  property->IndependentComponentsOff();
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  property->SetScalarOpacity(opacity);
  for (int component = 0; component < 4; ++component) // VTK takes that of the opacity's component
  {
    property->SetScalarOpacityUnitDistance(component, unitDistance);
  }
}

template <class Scalar>
bool RunEvaluation(
  volumeoptics::VoxelImage<Scalar>& image, bool marksRange, long long bricks, volumeoptics::Batches& batches)
{
  const bool isDone = batches.Run(bricks, 0.7, [&](long long brick) { image.EvaluateBrick(brick); }) &&
    batches.Run(bricks, 1.0, [&](long long brick) { image.SpreadBrick(brick); });
  if (isDone && marksRange)
  {
    image.MarkOpacityRange();
  }
  return isDone;
}
}

//------------------------------------------------------------------------------
vtkAnisotropicVoxelEvaluator::vtkAnisotropicVoxelEvaluator()
  : Cropping(std::make_unique<volumeoptics::BlockCropping>())
{
}

//------------------------------------------------------------------------------
vtkAnisotropicVoxelEvaluator::~vtkAnisotropicVoxelEvaluator() = default;

//------------------------------------------------------------------------------
void vtkAnisotropicVoxelEvaluator::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Cropping->Follow(camera);
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
void vtkAnisotropicVoxelEvaluator::SetOpacityLength(double share)
{
  volumeoptics::SetWithinRange(this, "OpacityLength", share, 1.0 / 256.0, 1.0, this->OpacityLength);
}

//------------------------------------------------------------------------------
double vtkAnisotropicVoxelEvaluator::GetOutputOpacityLength() const
{
  return this->OutputScalarType == VTK_UNSIGNED_CHAR ? 1.0 : this->OpacityLength;
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
  auto* voxels = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  const bool isOnCPU = DrawsOnCPU(volume->GetMapper());
  if (isOnCPU)
  {
    this->SetOutputScalarType(VTK_UNSIGNED_CHAR);
  }
  const double distance = this->GetOutputOpacityLength() * GetScalarOpacityUnitDistance(voxels);
  SetUpProperty(volume->GetProperty(), volumeoptics::LargestOfScalar(this->OutputScalarType),
    distance > 0.0 ? distance : 1.0);
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  if (mapper)
  {
    mapper->SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper::NATIVE);
  }
  this->SetMarkOpacityRange(!mapper && !isOnCPU);
}

//------------------------------------------------------------------------------
// The box of the block's image, from the first voxels' middles to the last ones'.
void vtkAnisotropicVoxelEvaluator::CropAroundBlock(
  vtkImageData* block, vtkVolumeMapper* behind, vtkVolumeMapper* inFront)
{
  this->Cropping->Clear();
  if (!block || !behind || !inFront)
  {
    return;
  }
  std::string error;
  const LineVoxels voxels(block, error);
  if (!error.empty())
  {
    vtkErrorMacro("The block holds " << error << ". Give the output of vtkAnisotropicLineVoxelizer.");
    return;
  }
  const glm::dvec3 first = voxels.Grid.CenterOf(glm::ivec3(0));
  const glm::dvec3 last = voxels.Grid.CenterOf(voxels.Grid.Dimensions - 1);
  this->Cropping->Set({ first.x, last.x, first.y, last.y, first.z, last.z }, behind, inFront);
}

//------------------------------------------------------------------------------
bool vtkAnisotropicVoxelEvaluator::CheckLights(vtkLightCollection* lights)
{
  vtkAlgorithmOutput* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputConnection(0, 0) : nullptr;
  auto* voxels = input ? vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0)) : nullptr;
  const bool areEqual = !voxels || volumeoptics::HasLights(voxels, volumeoptics::ReadLights(lights));
  if (!areEqual && !this->HasWarnedOfLights)
  {
    vtkWarningMacro(
      "The lights are not those that the voxels were made with, which are drawn. Give these lights to "
      "vtkAnisotropicLineVoxelizer by SetLights().");
  }
  this->HasWarnedOfLights = !areEqual;
  return areEqual;
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
  const volumeoptics::ViewOfVoxels view(this->Camera);
  const bool perVoxel = this->ViewDirections == PerVoxel && !this->Camera->GetParallelProjection();
  volumeoptics::Batches batches(this);
  const auto run = [&](auto zero) {
    volumeoptics::VoxelImage<decltype(zero)> image(voxels, view, perVoxel, output);
    image.Scales = scales;
    image.Function = this->OpacityFunction;
    image.OpacityLength = this->GetOutputOpacityLength();
    return RunEvaluation(image, this->MarkOpacityRange, voxels.Grid.NumberOfBricks(), batches);
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
  os << indent << "OpacityLength: " << this->OpacityLength << "\n";
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
