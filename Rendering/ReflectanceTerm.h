// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The light of a sample, wherever the scene asks for other than VTK's own: a phase function and a
// reflectance model [Ament2015], or VTK's Phong model with what other terms add at their places.

#ifndef ReflectanceTerm_h
#define ReflectanceTerm_h

#include "OpticsTerm.h"

class FrameTerm;

class ReflectanceTerm : public OpticsTerm
{
public:
  explicit ReflectanceTerm(const FrameTerm& frames)
    : Frames(frames)
  {
  }
  const char* GetName() const override { return "Reflectance"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override {}
  void ReleaseGraphicsResources(vtkWindow*) override {}
  std::size_t GetMemorySize() const override { return 0; }

private:
  const FrameTerm& Frames;
};

#endif
