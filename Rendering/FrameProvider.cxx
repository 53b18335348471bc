// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameProvider.h"

#include "FrameGeometry.h"
#include "OpticsTerm.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>

namespace
{
// While the user interacts, frames are estimated on a grid of an eighth of the voxels.
const double CoarseFactor = 0.5;

vtkFloatArray* FindArray(vtkImageData* image, const char* name, int components)
{
  auto* array = image ? vtkFloatArray::FastDownCast(image->GetPointData()->GetArray(name)) : nullptr;
  const bool fits = array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() > 0 &&
    array->GetNumberOfTuples() == image->GetNumberOfPoints();
  return fits ? array : nullptr;
}

vtkFloatArray* FindAnisotropy(vtkImageData* image)
{
  vtkFloatArray* array = FindArray(image, "AmbientCovariance", 3);
  return array ? array : FindArray(image, "AmbientCovariance", 5);
}

vtkImageData* UpdatedImage(const FrameProvider::Connection& connection)
{
  connection.Producer->Update(connection.Port);
  return vtkImageData::SafeDownCast(connection.Producer->GetOutputDataObject(connection.Port));
}

// Forwards a filter's progress as VTK's own gradient events, and the window's abort to the filter.
struct Watch
{
  const OpticsScene& Scene;
  double Begin;
  double Share;
};

void ReportProgress(vtkObject* caller, unsigned long, void* data, void*)
{
  const auto* watch = static_cast<Watch*>(data);
  auto* filter = static_cast<vtkAlgorithm*>(caller);
  double progress = watch->Begin + watch->Share * filter->GetProgress();
  watch->Scene.Mapper->InvokeEvent(vtkCommand::VolumeMapperComputeGradientsProgressEvent, &progress);
  if (watch->Scene.Window->CheckAbortStatus())
  {
    filter->SetAbortExecute(1);
  }
}

// False if the user aborted: what the filter left is then not whole.
bool Run(vtkAlgorithm* filter, Watch watch)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(ReportProgress);
  command->SetClientData(&watch);
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->SetAbortExecute(0);
  filter->Update();
  filter->RemoveObserver(tag);
  const bool isAborted = filter->GetAbortExecute() != 0;
  if (isAborted)
  {
    filter->SetAbortExecute(0);
    filter->Modified();
  }
  return !isAborted;
}
}

//------------------------------------------------------------------------------
FrameProvider::Connection::Connection(vtkAlgorithmOutput* output)
  : Producer(output ? output->GetProducer() : nullptr)
  , Port(output ? output->GetIndex() : 0)
{
}

//------------------------------------------------------------------------------
FrameProvider::Connection::Connection(vtkImageData* image)
{
  if (image)
  {
    auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
    producer->SetOutput(image);
    this->Producer = producer;
  }
}

//------------------------------------------------------------------------------
FrameProvider::FrameProvider()
{
  this->Covariance->SetInputConnection(1, this->Sobel->GetOutputPort());
}

FrameProvider::~FrameProvider() = default;

//------------------------------------------------------------------------------
FrameGrid FrameProvider::Update(const OpticsScene& scene, const Request& request)
{
  FrameGrid grid;
  auto* input = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  vtkImageData* normals = this->NormalsInput.Producer ? UpdatedImage(this->NormalsInput) : input;
  grid.Normals = FindArray(normals, "Normals", 3);
  grid.Magnitude = FindArray(normals, "GradientMagnitude", 1);
  vtkImageData* anisotropy = this->AnisotropyInput.Producer ? UpdatedImage(this->AnisotropyInput) : input;
  grid.Anisotropy = request.Anisotropy ? FindAnisotropy(anisotropy) : nullptr;
  const bool hasNormals = grid.Normals && grid.Magnitude;
  const bool isComplete = hasNormals && (grid.Anisotropy || !request.Anisotropy);
  if (isComplete && (!request.Anisotropy || HaveSameGrid(normals, anisotropy)))
  {
    grid.Geometry = normals;
    return grid;
  }
  this->UpdateInput(scene);
  const bool isAlone =
    hasNormals && !this->AnisotropyInput.Producer && !FindAnisotropy(input) && !request.Curvature;
  const double factor = isAlone ? FactorBetween(this->Input, normals) : 0.0;
  this->SetGivenNormals(factor > 0.0 ? normals : nullptr);
  if (this->Given)
  {
    return this->RunFilters(scene, request, factor);
  }
  if (this->NormalsInput.Producer || this->AnisotropyInput.Producer)
  {
    scene.Mapper->Say(
      "The connected normals and anisotropy cannot be used: they must be float point arrays "
      "Normals (3 components), GradientMagnitude (1) and AmbientCovariance (3 or 5) on one "
      "grid; normals alone must lie on the volume's grid, or on that of a lower resolution factor, and "
      "go with the frame source Covariance. They are computed from the input instead.");
  }
  return this->RunFilters(scene, request, this->GetResolutionFactor(scene, request));
}

//------------------------------------------------------------------------------
void FrameProvider::SetGivenNormals(vtkImageData* normals)
{
  const vtkMTimeType time = normals ? normals->GetMTime() : 0;
  if (!normals && this->Given)
  {
    this->Covariance->SetInputConnection(1, this->Sobel->GetOutputPort());
    this->Given = nullptr;
  }
  if (!normals || (this->Given && this->GivenSource == normals && this->GivenTime == time))
  {
    return;
  }
  // an image of its own: the filter's pipeline does not reach into that of the normals
  this->Given = vtkSmartPointer<vtkImageData>::New();
  this->Given->CopyStructure(normals);
  this->Given->GetPointData()->AddArray(FindArray(normals, "Normals", 3));
  this->Given->GetPointData()->AddArray(FindArray(normals, "GradientMagnitude", 1));
  this->GivenSource = normals;
  this->GivenTime = time;
  this->Covariance->SetNormalsData(this->Given);
}

//------------------------------------------------------------------------------
void FrameProvider::UpdateInput(const OpticsScene& scene)
{
  auto* source = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const vtkMTimeType time = std::max(source->GetMTime(), scene.Scalars->GetMTime());
  if (this->Input && this->Source == source && this->SourceTime == time &&
    this->Input->GetPointData()->GetScalars() == scene.Scalars)
  {
    return;
  }
  this->Input = vtkSmartPointer<vtkImageData>::New();
  this->Input->CopyStructure(source);
  if (scene.CellScalars)
  {
    MakeCentresPoints(source, this->Input);
  }
  else if (source->GetPointGhostArray())
  {
    this->Input->GetPointData()->AddArray(source->GetPointGhostArray());
  }
  this->Input->GetPointData()->SetScalars(scene.Scalars);
  this->Source = source;
  this->SourceTime = time;
  this->Sobel->SetInputData(this->Input);
  this->CurvatureSobel->SetInputData(this->Input);
  this->Covariance->SetInputData(0, this->Input);
  this->Curvature->SetInputData(this->Input);
}

//------------------------------------------------------------------------------
int FrameProvider::GetStorage(const Request& request)
{
  return request.Curvature ? this->Curvature->GetStorage() : this->Covariance->GetStorage();
}

//------------------------------------------------------------------------------
double FrameProvider::GetResolutionFactor(const OpticsScene& scene, const Request& request)
{
  const double wanted = request.ResolutionFactor * (request.Coarse ? CoarseFactor : 1.0);
  const double limit = 1.0 * scene.Mapper->GetMaxMemoryInBytes() * scene.Mapper->GetMaxMemoryFraction();
  const double voxels = static_cast<double>(this->Input->GetNumberOfPoints()) * std::pow(wanted, 3);
  const bool isWorld = this->GetStorage(request) == vtkAnisotropyFilter::World;
  const int numbers = 4 + (request.Anisotropy ? (isWorld ? 5 : 3) : 0);
  const double bytes = voxels * numbers * request.Bits / 8;
  if (limit <= 0.0 || bytes <= limit)
  {
    return wanted;
  }
  const double factor = std::max(SmallestResolutionFactor, wanted * std::cbrt(limit / bytes));
  if (request.Coarse)
  {
    return factor; // the still frame has more to say
  }
  std::ostringstream message;
  message << "Normals and anisotropy of the volume would take " << bytes / 1048576.0
          << " MiB of textures; the mapper's limit is " << limit / 1048576.0
          << " MiB. They are computed at a resolution factor of " << factor
          << ". Raise SetMaxMemoryInBytes() or lower SetFramePrecision() for more.";
  scene.Mapper->Say(message.str());
  return factor;
}

//------------------------------------------------------------------------------
bool FrameProvider::IsCurrent(const Request& request) const
{
  const bool isEnough =
    this->StoredCurvature == request.Curvature && (this->Stored.Anisotropy || !request.Anisotropy);
  return this->Stored.Normals && this->StoredTime == this->GetTime() && isEnough;
}

//------------------------------------------------------------------------------
bool FrameProvider::IsFine(const Request& request, double factor) const
{
  return request.Coarse ? this->StoredFactor >= factor : this->StoredFactor == factor;
}

//------------------------------------------------------------------------------
vtkMTimeType FrameProvider::GetTime() const
{
  return std::max({ this->Input->GetMTime(), this->Sobel->GetMTime(), this->CurvatureSobel->GetMTime(),
    this->Covariance->GetMTime(), this->Curvature->GetMTime() });
}

//------------------------------------------------------------------------------
FrameGrid FrameProvider::RunFilters(const OpticsScene& scene, const Request& request, double factor)
{
  const bool isCurrent = this->IsCurrent(request);
  if (isCurrent && this->IsFine(request, factor))
  {
    return this->GetStored(request.Anisotropy);
  }
  this->SetUpFilters(scene, factor);
  vtkAlgorithm* anisotropy = request.Curvature ? static_cast<vtkAlgorithm*>(this->Curvature)
                                               : static_cast<vtkAlgorithm*>(this->Covariance);
  const double share = this->Given ? 0.0 : request.Anisotropy ? 0.1 : 1.0;
  scene.Mapper->InvokeEvent(vtkCommand::VolumeMapperComputeGradientsStartEvent);
  const bool isDone = (this->Given || Run(this->GetNormals(request), Watch{ scene, 0.0, share })) &&
    (!request.Anisotropy || Run(anisotropy, Watch{ scene, share, 1.0 - share }));
  scene.Mapper->InvokeEvent(vtkCommand::VolumeMapperComputeGradientsEndEvent);
  if (isDone)
  {
    this->Store(request, factor);
  }
  else if (isCurrent)
  {
    this->StoredTime = this->GetTime(); // another resolution of the same data goes on serving
  }
  else
  {
    this->Stored = {};
  }
  return this->GetStored(request.Anisotropy);
}

//------------------------------------------------------------------------------
vtkSobelNormalFilter* FrameProvider::GetNormals(const Request& request)
{
  return request.Curvature ? this->CurvatureSobel : this->Sobel;
}

//------------------------------------------------------------------------------
void FrameProvider::SetUpFilters(const OpticsScene& scene, double factor)
{
  this->CurvatureSobel->SetSmoothing(this->Curvature->GetSmoothing());
  const std::initializer_list<vtkOpticsImageFilter*> filters = { this->Sobel, this->CurvatureSobel,
    this->Covariance, this->Curvature };
  for (vtkOpticsImageFilter* filter : filters)
  {
    filter->SetResolutionFactor(factor);
    filter->SetInputComponent(scene.OpacityComponent);
  }
}

//------------------------------------------------------------------------------
void FrameProvider::Store(const Request& request, double factor)
{
  vtkImageData* normals = this->Given ? this->Given.Get() : this->GetNormals(request)->GetOutput();
  // the filter's own image changes when a computation begins that may not end
  this->Stored.Geometry = vtkSmartPointer<vtkImageData>::New();
  this->Stored.Geometry->CopyStructure(normals);
  this->Stored.Normals = FindArray(normals, "Normals", 3);
  this->Stored.Magnitude = FindArray(normals, "GradientMagnitude", 1);
  this->Stored.Anisotropy = nullptr;
  if (request.Anisotropy)
  {
    this->Stored.Anisotropy =
      FindAnisotropy(request.Curvature ? this->Curvature->GetOutput() : this->Covariance->GetOutput());
  }
  this->StoredCurvature = request.Curvature;
  this->StoredFactor = factor;
  this->StoredTime = this->GetTime();
}

//------------------------------------------------------------------------------
FrameGrid FrameProvider::GetStored(bool withAnisotropy) const
{
  FrameGrid grid;
  if (this->Stored.Normals && this->Stored.Magnitude && (this->Stored.Anisotropy || !withAnisotropy))
  {
    grid.Geometry = this->Stored.Geometry;
    grid.Normals = this->Stored.Normals;
    grid.Magnitude = this->Stored.Magnitude;
    grid.Anisotropy = withAnisotropy ? this->Stored.Anisotropy.Get() : nullptr;
  }
  return grid;
}
