// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Ambient light: its colour, and how much of it the volume in front of a sample leaves over, by a visibility
// sweep from the eye [Schott2009].

#ifndef OcclusionTerm_h
#define OcclusionTerm_h

#include "OpticsTerm.h"
#include "vtkVisibilitySweep.h"

#include "vtkNew.h"

class SweepGrid;

class OcclusionTerm : public OpticsTerm
{
public:
  OcclusionTerm();
  ~OcclusionTerm() override;

  const char* GetName() const override { return "Occlusion"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void BeforeDraw(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetMemorySize() const override;

  vtkVisibilitySweep* GetSweep() const { return this->Eye; }

private:
  bool Sweep(const OpticsScene& scene, const vtkVisibilitySweep::Volume& volume, const SweepGrid& grid);

  vtkNew<vtkVisibilitySweep> Eye;
  bool IsBound = false;
};

#endif
