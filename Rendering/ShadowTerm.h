// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Volumetric shadows: how much of each light passes the volume, and the opaque geometry of the renderer, on
// its way to a sample; by a visibility sweep from the light, in each of its views.

#ifndef ShadowTerm_h
#define ShadowTerm_h

#include "OpaqueDepth.h"
#include "OpticsTerm.h"
#include "ShadowAtlas.h"
#include "SweepGrid.h"
#include "vtkVisibilitySweep.h"

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkLight;

class ShadowTerm : public OpticsTerm
{
public:
  ShadowTerm();
  ~ShadowTerm() override;

  const char* GetName() const override { return "Shadows"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void BeforeDraw(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetMemorySize() const override;

  /** Sweeps of all lights' views that there are. */
  int GetSweepCount() const;

private:
  struct LightView
  {
    SweepGrid Grid;
    double LightDistance; // from the middle of the volume
  };

  void FindViews(const OpticsScene& scene);
  void AddLight(const OpticsScene& scene, vtkLight* light, const double corners[24]);
  bool Allocate(const OpticsScene& scene);
  void DrawGeometry(const OpticsScene& scene);
  bool SweepAll(const OpticsScene& scene, const vtkVisibilitySweep::Volume& volume);
  bool Sweep(const OpticsScene& scene, vtkVisibilitySweep::Volume volume, std::size_t view);
  void ReleaseGeometry(vtkWindow* window);
  void SetSlices(const double textureToWorld[16], vtkShaderProgram* program);
  void SetViewUniforms(const double textureToWorld[16], vtkShaderProgram* program);

  std::vector<LightView> Views;
  std::vector<std::array<float, 3>> ViewsOfLights;         // first, behind the last, attenuation
  std::vector<vtkSmartPointer<vtkVisibilitySweep>> Sweeps; // one a view
  std::vector<OpaqueDepth> Geometry;                       // one a view where there is some, or none
  ShadowAtlas Atlas;
};

#endif
