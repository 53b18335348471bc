// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The integral along a ray, segment by segment, wherever the scene asks for other than VTK's sum over
// samples: in data space, or pre-integrated in either space [Kraus2005].

#ifndef IntegrationTerm_h
#define IntegrationTerm_h

#include "IsosurfaceTexture.h"
#include "OpticsTerm.h"
#include "PreIntegratedTexture.h"

class FrameTerm;

class IntegrationTerm : public OpticsTerm
{
public:
  explicit IntegrationTerm(const FrameTerm& frames)
    : Frames(frames)
  {
  }
  const char* GetName() const override { return "Integration"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetMemorySize() const override;

private:
  const FrameTerm& Frames;
  PreIntegratedTexture Table;
  IsosurfaceTexture Isosurfaces;
};

#endif
