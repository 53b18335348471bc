// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The light of a sample, wherever the scene asks for other than VTK's own: a phase function and a
// reflectance model [Ament2015], or VTK's Phong model with what other terms add at their places.

#ifndef ReflectanceTerm_h
#define ReflectanceTerm_h

#include "FrameProvider.h"
#include "FrameTextures.h"
#include "OpticsTerm.h"
#include "ScalarOpacityTexture.h"

class ReflectanceTerm : public OpticsTerm
{
public:
  const char* GetName() const override { return "Reflectance"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetMemorySize() const override;

  /** Whether light is evaluated here in this frame; known once it is prepared. */
  bool LightsScene() const { return this->IsLit; }

  FrameProvider Frames;

private:
  bool PrepareFrames(const OpticsScene& scene);
  void AddSurfaceFeatures(const OpticsScene& scene, OpticsFeatures& features) const;
  void SetGradientUniforms(const OpticsScene& scene, vtkShaderProgram* program);
  void SetSurfaceUniforms(const OpticsScene& scene, vtkShaderProgram* program);
  void SetExtinctionUniforms(const OpticsScene& scene, vtkShaderProgram* program);

  FrameTextures Textures;
  ScalarOpacityTexture Opacity;
  OpticsFeature Storage = OpticsFeature::AnisotropyMap;
  bool IsLit = false;
};

#endif
