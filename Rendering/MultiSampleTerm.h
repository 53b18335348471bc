// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour and opacity by (S, S1, S2) [Lum2004, section 7]: vtkMultiSampleClassification in the ray caster.

#ifndef MultiSampleTerm_h
#define MultiSampleTerm_h

#include "OpticsTerm.h"

class FrameTerm;

class MultiSampleTerm : public OpticsTerm
{
public:
  explicit MultiSampleTerm(const FrameTerm& frames)
    : Frames(frames)
  {
  }

  const char* GetName() const override { return "MultiSampleClassification"; }
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
