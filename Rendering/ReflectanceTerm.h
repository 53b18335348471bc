// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Anisotropic ambient shading [Ament2015]: a phase function and a reflectance model in place of
// VTK's Phong model.

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

  FrameProvider Frames;

private:
  void AddGradientFeatures(const OpticsScene& scene, OpticsFeatures& features) const;
  void SetSurfaceUniforms(const OpticsScene& scene, vtkShaderProgram* program);
  void SetExtinctionUniforms(const OpticsScene& scene, vtkShaderProgram* program);

  FrameTextures Textures;
  ScalarOpacityTexture Opacity;
  OpticsFeature Storage = OpticsFeature::AnisotropyMap;
};

#endif
