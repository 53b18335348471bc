// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The input as a piece of a larger volume: a part of it is drawn, with the samples that the whole would have.

#ifndef PieceTerm_h
#define PieceTerm_h

#include "OpticsTerm.h"

class PieceTerm : public OpticsTerm
{
public:
  const char* GetName() const override { return "Piece"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene&) override { return true; }
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene&, vtkShaderProgram*) override {}
  void BeforeDraw(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override {}
  void ReleaseGraphicsResources(vtkWindow*) override {}
  std::size_t GetMemorySize() const override { return 0; }
};

#endif
