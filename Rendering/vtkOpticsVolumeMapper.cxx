// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeMapper.h"

#include "DefaultOptics.h"
#include "EmptySpaceTerm.h"
#include "FrameTerm.h"
#include "IntegrationTerm.h"
#include "LightUniforms.h"
#include "LightingTransferFunctionTerm.h"
#include "MultiSampleTerm.h"
#include "OpticsFactory.h"
#include "ReflectanceTerm.h"
#include "TransferFunctionTerm.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkOpticsShaderPass.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
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
  EmptySpaceTerm EmptySpace;
  std::vector<OpticsTerm*> All = { &this->Frames, &this->TransferFunctions, &this->Reflectance,
    &this->LightingTransferFunction, &this->MultiSample, &this->Integration, &this->EmptySpace };
  vtkNew<vtkOpticsShaderPass> Pass;
  vtkSmartPointer<vtkOpticsVolumeProperty> Optics;
  vtkNew<vtkOpticsVolumeProperty> NoOptics; // VTK's own, of volumes that have none
  vtkWeakPointer<vtkRenderWindow> LastWindow;
  std::set<std::string> Said;
  std::string ActiveTerms;
};

//------------------------------------------------------------------------------
std::vector<OpticsTerm*> vtkOpticsVolumeMapper::Implementation::Prepare(const OpticsScene& scene)
{
  std::vector<OpticsTerm*> active;
  this->ActiveTerms.clear();
  if (!scene.Scalars || !scene.Window)
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
  OpticsScene scene = MakeOpticsScene(this, renderer, volume);
  scene.Optics = scene.Optics ? scene.Optics : this->Terms->NoOptics.Get();
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
bool vtkOpticsVolumeMapper::HasPartitions()
{
  const auto input = this->AssembledInputs.find(0);
  if (input == this->AssembledInputs.end() || !input->second.Texture)
  {
    return false;
  }
  const auto& partitions = input->second.Texture->GetPartitions();
  return partitions[0] > 1 || partitions[1] > 1 || partitions[2] > 1;
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
