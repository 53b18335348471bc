// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// One volume in one window: takes PictureSettings, renders, and tells the times.

#ifndef VolumeScene_h
#define VolumeScene_h

#include "PictureSettings.h"
#include "VolumeFile.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <utility>

class vtkImageData;
class vtkOpticsVolumeMapper;
class vtkProjectedTetrahedraMapper;
class vtkOpticsVolumeProperty;
class vtkRenderer;
class vtkRenderWindow;
class vtkVolume;

enum class WindowKind
{
  Headless, // no X server
  Hidden,   // X server, nothing shown
  Visible
};

// Headless where there is no display or the user wants it so.
WindowKind OffScreenWindow(bool headless);

class VolumeScene
{
public:
  VolumeScene(const Volume& volume, WindowKind kind);
  ~VolumeScene();
  VolumeScene(const VolumeScene&) = delete;
  VolumeScene& operator=(const VolumeScene&) = delete;

  void Apply(const PictureSettings& picture);
  // Seconds from the call to the finished frame.
  double Render();
  vtkSmartPointer<vtkImageData> Capture();
  void WritePng(const std::string& path);

  // Seconds that the mapper spent on normals and covariance since Apply().
  double GetPreparationSeconds() const { return this->PreparationSeconds; }
  // OpenGL's name of what draws, after the first frame.
  std::string GetRendererName();
  void SetPreparationCallback(std::function<void(double)> callback)
  {
    this->OnProgress = std::move(callback);
  }
  vtkRenderWindow* GetWindow();
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkOpticsVolumeProperty* GetProperty() { return this->Property; }
  vtkOpticsVolumeMapper* GetMapper() { return this->Mapper; }

private:
  void ApplyMapper(const IntegrationSettings& integration);
  void ApplyOptics(const OpticsSettings& optics);
  void ApplyVisibility(const VisibilitySettings& visibility);
  void ApplyClipping(const std::vector<ClippingSettings>& planes);
  void ApplyAmbient(const AmbientSettings& ambient);
  void ApplyQuality(const std::string& quality);
  void ApplyCamera(const CameraSettings& camera);
  void ApplyLights(const std::vector<LightSettings>& lights);
  static void OnPreparation(vtkObject*, unsigned long event, void* scene, void* data);

  Volume Data;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Actor;
  vtkNew<vtkOpticsVolumeMapper> Mapper;
  vtkNew<vtkOpticsVolumeProperty> Property;
  vtkSmartPointer<vtkProjectedTetrahedraMapper> Tetrahedra; // where the volume has some
  std::function<void(double)> OnProgress;
  double PreparationStart = 0.0;
  double PreparationSeconds = 0.0;
};

#endif
