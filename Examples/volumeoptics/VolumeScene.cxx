// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeScene.h"

#include "Lighting.h"
#include "OutputFile.h"
#include "Progress.h"
#include "ReadingGuard.h"
#include "UserError.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkDataSpaceProjectedTetrahedraMapper.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkProjectedTetrahedraMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>
#include <vtkVolume.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdlib>
#include <algorithm>
#include <map>
#include <sstream>

namespace
{
vtkSmartPointer<vtkRenderWindow> MakeWindow(WindowKind kind)
{
  if (kind == WindowKind::Headless)
  {
    return vtkSmartPointer<vtkHeadlessRenderWindow>::New();
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(kind != WindowKind::Visible);
  return window;
}

double MeanSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return std::cbrt(spacing[0] * spacing[1] * spacing[2]);
}
}

WindowKind OffScreenWindow(bool headless)
{
  const char* display = std::getenv("DISPLAY");
  return headless || display == nullptr || *display == '\0' ? WindowKind::Headless : WindowKind::Hidden;
}

VolumeScene::VolumeScene(const Volume& volume, WindowKind kind)
  : Data(volume)
  , Window(MakeWindow(kind))
{
  this->Mapper->SetInputData(volume.Image);
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Mapper->UseJitteringOff();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->SetProperty(this->Property);
  this->Renderer->AddVolume(this->Actor);
  this->Renderer->AutomaticLightCreationOff();
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);

  vtkNew<vtkCallbackCommand> preparation;
  preparation->SetCallback(VolumeScene::OnPreparation);
  preparation->SetClientData(this);
  for (const auto event : { vtkCommand::VolumeMapperComputeGradientsStartEvent,
         vtkCommand::VolumeMapperComputeGradientsProgressEvent,
         vtkCommand::VolumeMapperComputeGradientsEndEvent })
  {
    this->Mapper->AddObserver(event, preparation);
  }
}

VolumeScene::~VolumeScene()
{
  this->Window->Finalize();
}

void VolumeScene::OnPreparation(vtkObject*, unsigned long event, void* scene, void* data)
{
  auto* self = static_cast<VolumeScene*>(scene);
  if (event == vtkCommand::VolumeMapperComputeGradientsStartEvent)
  {
    self->PreparationStart = vtkTimerLog::GetUniversalTime();
  }
  else if (event == vtkCommand::VolumeMapperComputeGradientsEndEvent)
  {
    self->PreparationSeconds += vtkTimerLog::GetUniversalTime() - self->PreparationStart;
  }
  else if (data && self->OnProgress)
  {
    self->OnProgress(*static_cast<double*>(data));
  }
}

void VolumeScene::Apply(const PictureSettings& picture)
{
  this->PreparationSeconds = 0.0;
  ::Apply(picture.Function, this->Property);
  ::Apply(picture.Function.Integration, this->Property);
  this->ApplyMapper(picture.Function.Integration);
  this->ApplyOptics(picture.Optics);
  ::Apply(picture.Lighting, this->Property);
  this->ApplyVisibility(picture.Visibility);
  this->ApplyClipping(picture.ClippingPlanes);
  this->ApplyAmbient(picture.Ambient);
  this->ApplyQuality(picture.Quality);
  this->Mapper->SetSampleDistance(
    static_cast<float>(picture.Step > 0.0 ? picture.Step : 0.5 * MeanSpacing(this->Data.Image)));
  this->Window->SetSize(picture.Size[0], picture.Size[1]);
  this->Renderer->SetBackground(picture.Background.data());
  this->ApplyCamera(picture.Camera);
  this->ApplyLights(picture.Lights);
}

// VTK's own for tetrahedra in physical space.
void VolumeScene::ApplyMapper(const IntegrationSettings& integration)
{
  if (!this->Data.Tetrahedra)
  {
    return;
  }
  const bool inDataSpace = integration.Space == "data";
  if (!this->Tetrahedra ||
    inDataSpace != (this->Tetrahedra->IsA("vtkDataSpaceProjectedTetrahedraMapper") != 0))
  {
    this->Tetrahedra = inDataSpace ? vtkSmartPointer<vtkProjectedTetrahedraMapper>(
                                       vtkSmartPointer<vtkDataSpaceProjectedTetrahedraMapper>::New())
                                   : vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
    this->Tetrahedra->SetInputData(this->Data.Tetrahedra);
    this->Actor->SetMapper(this->Tetrahedra);
  }
}

void VolumeScene::ApplyOptics(const OpticsSettings& optics)
{
  static const std::map<std::string, int> models = { { "vtk", vtkOpticsVolumeProperty::VTK },
    { "none", vtkOpticsVolumeProperty::None }, { "blinn-phong", vtkOpticsVolumeProperty::BlinnPhong },
    { "ward", vtkOpticsVolumeProperty::Ward }, { "lafortune", vtkOpticsVolumeProperty::Lafortune } };
  const int model = models.at(optics.Model);
  const vtkNew<vtkOpticsVolumeProperty> defaults;
  this->Property->SetReflectanceModel(model);
  if (defaults->GetGlossiness(model) > 0.0)
  {
    this->Property->SetGlossiness(
      model, optics.Glossiness < 0.0 ? defaults->GetGlossiness(model) : optics.Glossiness);
  }
  if (defaults->GetAnisotropyScale(model) > 0.0)
  {
    this->Property->SetAnisotropyScale(
      model, optics.Anisotropy < 0.0 ? defaults->GetAnisotropyScale(model) : optics.Anisotropy);
  }
  this->Property->SetScatteringAnisotropy(static_cast<float>(optics.Scattering));
  this->Property->SetFrameSource(optics.FrameSource == "curvature" ? vtkOpticsVolumeProperty::Curvature
                                                                   : vtkOpticsVolumeProperty::Covariance);
}

void VolumeScene::ApplyVisibility(const VisibilitySettings& visibility)
{
  this->Property->SetOcclusion(visibility.OcclusionAngle >= 0.0);
  if (visibility.OcclusionAngle >= 0.0)
  {
    this->Property->SetOcclusionAngle(visibility.OcclusionAngle);
  }
  this->Property->SetAmbientColor(visibility.AmbientColor.data());
  this->Property->SetShadows(visibility.Shadows);
  this->Property->SetShadowAngle(visibility.ShadowAngle);
  static const std::map<std::string, int> algorithms = { { "sweep", vtkOpticsVolumeMapper::DirectionSweep },
    { "disk", vtkOpticsVolumeMapper::Disk }, { "disk-solid-angle", vtkOpticsVolumeMapper::DiskSolidAngle } };
  this->Mapper->SetVisibilityAlgorithm(algorithms.at(visibility.Algorithm));
  this->Mapper->SetVisibilityGridSize(visibility.GridSize);
  this->Mapper->SetVisibilitySliceDistance(visibility.SliceDistance);
  this->Mapper->SetVisibilitySamples(visibility.Samples);
  this->Mapper->SetVisibilityGatherSamples(visibility.GatherSamples);
  this->Mapper->SetVisibilityDiskSize(visibility.DiskSize);
}

void VolumeScene::ApplyClipping(const std::vector<ClippingSettings>& planes)
{
  this->Mapper->RemoveAllClippingPlanes();
  const double* bounds = this->Data.Image->GetBounds();
  for (const ClippingSettings& settings : planes)
  {
    double origin[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      origin[axis] = bounds[2 * axis] + settings.Place[axis] * (bounds[2 * axis + 1] - bounds[2 * axis]);
    }
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin);
    plane->SetNormal(settings.Normal.data());
    this->Mapper->AddClippingPlane(plane);
  }
}

void VolumeScene::ApplyAmbient(const AmbientSettings& ambient)
{
  vtkAmbientCovarianceFilter* covariance = this->Mapper->GetAmbientCovarianceFilter();
  covariance->SetRadius(ambient.Radius);
  covariance->SetNumberOfSamples(ambient.Samples);
  static const std::map<std::string, int> patterns = { { "shared", vtkAmbientCovarianceFilter::Shared },
    { "per-block", vtkAmbientCovarianceFilter::PerBlock },
    { "per-voxel", vtkAmbientCovarianceFilter::PerVoxel },
    { "exhaustive", vtkAmbientCovarianceFilter::Exhaustive } };
  covariance->SetSamplingPattern(patterns.at(ambient.Pattern));
  covariance->SetScalarTolerance(ambient.Tolerance);
  covariance->SetFilterStandardDeviation(ambient.FilterStandardDeviation);
  this->Mapper->SetFrameResolutionFactor(ambient.ResolutionFactor);
  this->Mapper->SetFramePrecision(ambient.Precision);
}

void VolumeScene::ApplyQuality(const std::string& quality)
{
  if (quality == "draft")
  {
    this->Mapper->SetQualityToDraft();
  }
  else if (quality == "balanced")
  {
    this->Mapper->SetQualityToBalanced();
  }
  else if (quality == "reference")
  {
    this->Mapper->SetQualityToReference();
  }
  else
  {
    this->Mapper->SetQualityToCustom();
  }
}

void VolumeScene::ApplyCamera(const CameraSettings& settings)
{
  vtkNew<vtkCamera> camera;
  this->Renderer->SetActiveCamera(camera);
  const double* center = this->Data.Image->GetCenter();
  const double distance = this->Data.Image->GetLength();
  camera->SetFocalPoint(settings.FocalPoint.empty() ? center : settings.FocalPoint.data());
  camera->SetViewUp(0.0, 0.0, 1.0);
  if (!settings.Position.empty())
  {
    camera->SetPosition(settings.Position.data());
  }
  else
  {
    camera->SetPosition(center[0], center[1] + this->Data.Front * distance, center[2]);
    this->Renderer->ResetCamera();
    camera->Azimuth(settings.Azimuth);
    camera->Elevation(settings.Elevation);
    camera->OrthogonalizeViewUp();
    camera->Roll(settings.Roll);
    camera->Zoom(settings.Zoom);
  }
  if (!settings.ViewUp.empty())
  {
    camera->SetViewUp(settings.ViewUp.data());
  }
  this->Renderer->ResetCameraClippingRange();
}

// Directions from the focal point to the lights, in the frame of a camera light: camera at z = 1.
void VolumeScene::ApplyLights(const std::vector<LightSettings>& lights)
{
  this->Renderer->RemoveAllLights();
  this->Renderer->SetTwoSidedLighting(
    std::none_of(lights.begin(), lights.end(), [](const LightSettings& light) { return light.OneSided; }));
  for (const LightSettings& settings : lights)
  {
    const double azimuth = vtkMath::RadiansFromDegrees(settings.Azimuth);
    const double elevation = vtkMath::RadiansFromDegrees(settings.Elevation);
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(
      std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation));
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetIntensity(settings.Intensity);
    this->Renderer->AddLight(light);
  }
}

vtkRenderWindow* VolumeScene::GetWindow()
{
  return this->Window;
}

double VolumeScene::Render()
{
  const VtkMessages messages;
  const double start = vtkTimerLog::GetUniversalTime();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const double seconds = vtkTimerLog::GetUniversalTime() - start;
  if (!messages.GetError().empty())
  {
    throw UserError("The picture cannot be drawn: " + messages.GetError() + ".");
  }
  if (!messages.GetWarning().empty())
  {
    Progress::Say("Warning: " + messages.GetWarning() + ".");
  }
  return seconds;
}

std::string VolumeScene::GetRendererName()
{
  std::istringstream report(this->Window->ReportCapabilities());
  const std::string label = "OpenGL renderer string:";
  for (std::string line; std::getline(report, line);)
  {
    if (line.compare(0, label.size(), label) == 0)
    {
      return line.substr(std::min(line.size(), line.find_first_not_of(' ', label.size())));
    }
  }
  return "an unknown machine";
}

vtkSmartPointer<vtkImageData> VolumeScene::Capture()
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  return grab->GetOutput();
}

void VolumeScene::WritePng(const std::string& path)
{
  WriteFile(path, [&](const std::string& temporary) {
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(temporary.c_str());
    writer->SetInputData(this->Capture());
    writer->Write();
    return writer->GetErrorCode() == 0;
  });
}
