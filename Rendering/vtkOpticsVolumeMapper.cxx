// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeMapper.h"

#include "DefaultOptics.h"
#include "FrameTerm.h"
#include "IntegrationTerm.h"
#include "LightUniforms.h"
#include "LightingTransferFunctionTerm.h"
#include "MultiSampleTerm.h"
#include "OpticsFactory.h"
#include "ParameterRange.h"
#include "QualityPresets.h"
#include "ReflectanceTerm.h"
#include "TransferFunctionTerm.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkOpticsShaderPass.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeTexture.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkOpticsVolumeMapper);

namespace
{
const char* const GradientTypeNames[] = { "Stored", "CentralDifferences", "Automatic" };
const char* const LightingSamplesNames[] = { "Fetched", "Extrapolated" };
}

class vtkOpticsVolumeMapper::Implementation
{
public:
  std::vector<OpticsTerm*> Prepare(const OpticsScene& scene);
  void LeaveOtherWindow(vtkOpticsVolumeMapper* mapper, vtkRenderWindow* window);

  // In the order of preparation: first what others build on.
  FrameTerm Frames;
  TransferFunctionTerm TransferFunctions;
  ReflectanceTerm Reflectance{ this->Frames };
  IntegrationTerm Integration{ this->Frames };
  LightingTransferFunctionTerm LightingTransferFunction{ this->Frames };
  MultiSampleTerm MultiSample{ this->Frames };
  std::vector<OpticsTerm*> All = { &this->Frames, &this->TransferFunctions, &this->Reflectance,
    &this->LightingTransferFunction, &this->MultiSample, &this->Integration };
  vtkNew<vtkOpticsShaderPass> Pass;
  vtkSmartPointer<vtkOpticsVolumeProperty> Optics;
  vtkWeakPointer<vtkRenderWindow> LastWindow;
  std::set<std::string> Said;
  std::string ActiveTerms;
};

//------------------------------------------------------------------------------
std::vector<OpticsTerm*> vtkOpticsVolumeMapper::Implementation::Prepare(const OpticsScene& scene)
{
  std::vector<OpticsTerm*> active;
  this->ActiveTerms.clear();
  if (!scene.Optics || !scene.Scalars || !scene.Window)
  {
    return active;
  }
  OpticsFeatures features;
  for (OpticsTerm* term : this->All)
  {
    if (term->IsActive(scene) && term->Prepare(scene))
    {
      term->AddFeatures(scene, features);
      active.push_back(term);
      const std::string name = term->GetName();
      this->ActiveTerms += (this->ActiveTerms.empty() || name.empty() ? "" : ",") + name;
    }
    else
    {
      term->ReleaseGraphicsResources(scene.Window);
    }
  }
  if (this->ActiveTerms.empty())
  {
    active.clear(); // what is left is only what others would have built on
  }
  this->Pass->SetFeatures(features);
  return active;
}

//------------------------------------------------------------------------------
// VTK's mapper gives up what it holds in another window in the midst of a frame, the terms' with it:
// do so before they are prepared.
void vtkOpticsVolumeMapper::Implementation::LeaveOtherWindow(
  vtkOpticsVolumeMapper* mapper, vtkRenderWindow* window)
{
  if (this->LastWindow && this->LastWindow != window)
  {
    mapper->ReleaseGraphicsResources(this->LastWindow);
  }
  this->LastWindow = window;
}

//------------------------------------------------------------------------------
vtkOpticsVolumeMapper::vtkOpticsVolumeMapper()
  : Terms(new Implementation)
{
}

//------------------------------------------------------------------------------
vtkOpticsVolumeMapper::~vtkOpticsVolumeMapper() = default;

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::GPURender(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Terms->LeaveOtherWindow(this, renderer->GetRenderWindow());
  renderer->GetRenderWindow()->MakeCurrent();
  this->UpdateSampleDistance(renderer);
  const LightLimit limit(renderer);
  if (limit.GetNumberOfLightsLeftOut() > 0)
  {
    this->Say("The renderer has more lights than the " + std::to_string(LightLimit::Largest) +
      " that this VTK's volume shader holds: the last ones are left out.");
  }
  const OpticsScene scene = MakeOpticsScene(this, renderer, volume);
  const std::vector<OpticsTerm*> active = this->Terms->Prepare(scene);
  if (active.empty())
  {
    this->Superclass::GPURender(renderer, volume);
    return;
  }
  this->Terms->Pass->Attach(scene, active);
  this->Superclass::GPURender(renderer, volume);
  this->Terms->Pass->Detach();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  const std::string missing = this->FindMissing();
  if (missing.empty())
  {
    this->Superclass::Render(renderer, volume);
  }
  else if (this->Terms->Said.insert(missing).second)
  {
    vtkErrorMacro(<< missing);
  }
}

//------------------------------------------------------------------------------
std::string vtkOpticsVolumeMapper::FindMissing()
{
  if (this->GetInputCount() > 1 || this->GetNumberOfInputConnections(0) == 0)
  {
    return std::string(); // VTK looks at each of several volumes, and says itself that there is none
  }
  this->Update();
  int cellFlag = 0;
  vtkDataArray* scalars = GetScalars(this->GetDataSetInput(), this->GetScalarMode(),
    this->GetArrayAccessMode(), this->GetArrayId(), this->GetArrayName(), cellFlag);
  if (scalars && scalars->GetNumberOfTuples() > 0)
  {
    return std::string();
  }
  const char* name = this->GetArrayName();
  return "The volume has no scalars to draw" +
    (name && *name ? " (array \"" + std::string(name) + "\")" : "") +
    ". Give its points or cells scalars, or name one of its arrays by SelectScalarArray().";
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (OpticsTerm* term : this->Terms->All)
  {
    term->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetOptics(vtkOpticsVolumeProperty* optics)
{
  if (this->Terms->Optics != optics)
  {
    this->Terms->Optics = optics;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty* vtkOpticsVolumeMapper::GetOptics()
{
  return this->Terms->Optics;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetNormalsInputConnection(vtkAlgorithmOutput* output)
{
  this->Terms->Frames.Provider.NormalsInput = FrameProvider::Connection(output);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetNormalsInputData(vtkImageData* normals)
{
  this->Terms->Frames.Provider.NormalsInput = FrameProvider::Connection(normals);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetAnisotropyInputConnection(vtkAlgorithmOutput* output)
{
  this->Terms->Frames.Provider.AnisotropyInput = FrameProvider::Connection(output);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetAnisotropyInputData(vtkImageData* anisotropy)
{
  this->Terms->Frames.Provider.AnisotropyInput = FrameProvider::Connection(anisotropy);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkSobelNormalFilter* vtkOpticsVolumeMapper::GetSobelNormalFilter()
{
  return this->Terms->Frames.Provider.Sobel;
}

//------------------------------------------------------------------------------
vtkAmbientCovarianceFilter* vtkOpticsVolumeMapper::GetAmbientCovarianceFilter()
{
  return this->Terms->Frames.Provider.Covariance;
}

//------------------------------------------------------------------------------
vtkPrincipalCurvatureFilter* vtkOpticsVolumeMapper::GetPrincipalCurvatureFilter()
{
  return this->Terms->Frames.Provider.Curvature;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetFramePrecision(int bits)
{
  volumeoptics::SetPrecision(this, "FramePrecision", bits, this->FramePrecision);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetPreIntegrationTableSize(int size)
{
  volumeoptics::SetWithinRange(this, "PreIntegrationTableSize", size, 2, 4096, this->PreIntegrationTableSize);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetTablePrecision(int bits)
{
  if (bits != 16 && bits != 32)
  {
    vtkWarningMacro(<< "TablePrecision " << bits << " is not set: choose 16 or 32.");
    return;
  }
  if (this->TablePrecision != bits)
  {
    this->TablePrecision = bits;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetExtinctionGradientAsString()
{
  return GradientTypeNames[this->ExtinctionGradient];
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetScalarGradientAsString()
{
  return GradientTypeNames[this->ScalarGradient];
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetLightingSamplesAsString()
{
  return LightingSamplesNames[this->LightingSamples];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetQuality(int quality)
{
  this->Quality = std::clamp(quality, static_cast<int>(Custom), static_cast<int>(Reference));
  this->Modified();
  if (this->Quality == Custom)
  {
    this->StepInVoxels = 0.0;
    return;
  }
  const QualityPreset& preset = QualityPresets[this->Quality];
  this->StepInVoxels = preset.StepInVoxels;
  this->SetFrameResolutionFactor(preset.ResolutionFactor);
  this->SetFramePrecision(preset.Bits);
  this->GetAmbientCovarianceFilter()->SetNumberOfSamples(preset.Samples);
  this->GetAmbientCovarianceFilter()->SetFilterStandardDeviation(preset.FilterStandardDeviation);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetSampleDistance(float distance)
{
  this->StepInVoxels = 0.0;
  this->Superclass::SetSampleDistance(distance);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::UpdateSampleDistance(vtkRenderer* renderer)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  if (this->StepInVoxels <= 0.0 || !image)
  {
    return;
  }
  const double* spacing = image->GetSpacing();
  const double smallest = std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  const double slack = this->IsInteractive(renderer) ? 2.0 : 1.0;
  this->SetAutoAdjustSampleDistances(0);
  this->Superclass::SetSampleDistance(static_cast<float>(this->StepInVoxels * slack * smallest));
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetQualityAsString()
{
  const char* const names[] = { "Custom", "Draft", "Balanced", "Reference" };
  return names[this->Quality];
}

//------------------------------------------------------------------------------
std::string vtkOpticsVolumeMapper::GetActiveTerms()
{
  return this->Terms->ActiveTerms;
}

//------------------------------------------------------------------------------
unsigned long vtkOpticsVolumeMapper::GetTermMemorySize()
{
  std::size_t bytes = 0;
  for (OpticsTerm* term : this->Terms->All)
  {
    bytes += term->GetMemorySize();
  }
  return static_cast<unsigned long>((bytes + 1023) / 1024);
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeMapper::GetProgramLinkCount()
{
  return this->Terms->Pass->GetProgramLinkCount();
}

//------------------------------------------------------------------------------
std::string vtkOpticsVolumeMapper::GetFragmentShader()
{
  return this->Terms->Pass->GetFragmentShader();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::Say(const std::string& message)
{
  if (this->Terms->Said.insert(message).second)
  {
    vtkWarningMacro(<< message);
  }
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::IsInteractive(vtkRenderer* renderer)
{
  vtkRenderWindowInteractor* interactor = renderer->GetRenderWindow()->GetInteractor();
  return interactor && interactor->GetInteractorStyle() &&
    renderer->GetRenderWindow()->GetDesiredUpdateRate() > interactor->GetStillUpdateRate();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::GetLoadedScalarRange(int component, double range[2])
{
  const auto& loaded = this->AssembledInputs[0].Texture->ScalarRange[component];
  range[0] = loaded[0];
  range[1] = loaded[1];
}

//------------------------------------------------------------------------------
// VTK keeps it to itself; the same rules. For images.
double vtkOpticsVolumeMapper::GetFrameSampleDistance(vtkVolume* volume)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  double spacing[3];
  image->GetSpacing(spacing);
  if (this->AutoAdjustSampleDistances)
  {
    double least = VTK_DOUBLE_MAX;
    for (int axis = 0; axis < 3; ++axis)
    {
      double column[3];
      for (int row = 0; row < 3; ++row)
      {
        column[row] = volume->GetMatrix()->GetElement(row, axis);
      }
      least = std::min(least, std::abs(spacing[axis]) * vtkMath::Norm(column));
    }
    return this->ReductionFactor > 0.0 && this->ReductionFactor < 1.0 ? least / this->ReductionFactor : least;
  }
  return this->LockSampleDistanceToInputSpacing
    ? this->SpacingAdjustedSampleDistance(spacing, image->GetExtent())
    : this->SampleDistance;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetGlobalOverride(bool enabled)
{
  OpticsFactory::SetEnabled("vtkGPUVolumeRayCastMapper", enabled);
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::GetGlobalOverride()
{
  return OpticsFactory::GetEnabled("vtkGPUVolumeRayCastMapper");
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetDefaultOptics(vtkOpticsVolumeProperty* property)
{
  DefaultOptics::Set(property);
}

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty* vtkOpticsVolumeMapper::GetDefaultOptics()
{
  return DefaultOptics::Get();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Optics: " << this->Terms->Optics.Get() << "\n";
  os << indent << "FrameResolutionFactor: " << this->FrameResolutionFactor << "\n";
  os << indent << "FramePrecision: " << this->FramePrecision << "\n";
  os << indent << "ExtinctionGradient: " << this->GetExtinctionGradientAsString() << "\n";
  os << indent << "ScalarGradient: " << this->GetScalarGradientAsString() << "\n";
  os << indent << "LightingTableSize: " << this->LightingTableSize << "\n";
  os << indent << "LightingSamples: " << this->GetLightingSamplesAsString() << "\n";
  os << indent << "PreIntegrationTableSize: " << this->PreIntegrationTableSize << "\n";
  os << indent << "TablePrecision: " << this->TablePrecision << "\n";
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "ActiveTerms: " << this->Terms->ActiveTerms << "\n";
  os << indent << "TermMemorySize: " << this->GetTermMemorySize() << " KiB\n";
  os << indent << "ProgramLinkCount: " << this->GetProgramLinkCount() << "\n";
}
