// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Coefficients of light by a lighting transfer function [Lum2004], in place of the property's; light
// itself is the reflectance term's.

#ifndef LightingTransferFunctionTerm_h
#define LightingTransferFunctionTerm_h

#include "LightingTableTexture.h"
#include "OpticsTerm.h"

class FrameTerm;

class LightingTransferFunctionTerm : public OpticsTerm
{
public:
  explicit LightingTransferFunctionTerm(const FrameTerm& frames)
    : Frames(frames)
  {
  }

  const char* GetName() const override { return "LightingTransferFunction"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override { this->Table.Unbind(); }
  void ReleaseGraphicsResources(vtkWindow* window) override { this->Table.Release(window); }
  std::size_t GetMemorySize() const override { return this->Table.GetMemorySize(); }

private:
  const FrameTerm& Frames;
  LightingTableTexture Table;
};

#endif
