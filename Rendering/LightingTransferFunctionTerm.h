// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Coefficients of light by a lighting transfer function [Lum2004], in place of the property's; light
// itself is the reflectance term's.

#ifndef LightingTransferFunctionTerm_h
#define LightingTransferFunctionTerm_h

#include "LightingTableTexture.h"
#include "OpticsTerm.h"

class ReflectanceTerm;

class LightingTransferFunctionTerm : public OpticsTerm
{
public:
  /** light: the term that evaluates it, prepared before this one in each frame. */
  explicit LightingTransferFunctionTerm(const ReflectanceTerm& light)
    : Light(light)
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

  /** Whether the scene's normals take their side from the classified density. */
  static bool HasHybridNormals(const OpticsScene& scene);

private:
  const ReflectanceTerm& Light;
  LightingTableTexture Table;
};

#endif
