// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Geometry of the data that other terms build on: stored normals and tangent frames, and the gradient of
// the scalar. Active where one of them asks for it; not listed among the terms.

#ifndef FrameTerm_h
#define FrameTerm_h

#include "FrameProvider.h"
#include "FrameTextures.h"
#include "OpticsTerm.h"

class FrameTerm : public OpticsTerm
{
public:
  const char* GetName() const override { return ""; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override { this->Textures.Unbind(); }
  void ReleaseGraphicsResources(vtkWindow* window) override { this->Textures.Release(window); }
  std::size_t GetMemorySize() const override { return this->Textures.GetMemorySize(); }

  /** Whether what the scene needs of normals is there: Prepare() of this frame has found it. */
  bool Serves(const OpticsScene& scene) const;

  FrameProvider Provider;

private:
  bool PrepareTextures(const OpticsScene& scene);

  FrameTextures Textures;
  OpticsFeature Storage = OpticsFeature::AnisotropyMap;
  bool HasTextures = false;
};

#endif
