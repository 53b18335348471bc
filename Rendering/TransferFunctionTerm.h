// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The transfer functions that other terms look up at a sample. Active where one of them asks for it; not
// listed among the terms.

#ifndef TransferFunctionTerm_h
#define TransferFunctionTerm_h

#include "OpticsTerm.h"
#include "TransferFunctionTexture.h"

class TransferFunctionTerm : public OpticsTerm
{
public:
  const char* GetName() const override { return ""; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene&) override { return true; }
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetMemorySize() const override;

  ///@{
  /**
   * The scalars that the coordinates 0 and 1 of VTK's tables stand for. After VTK has loaded the volume.
   */
  static void GetOpacityRange(const OpticsScene& scene, double range[2]);
  static void GetColorRange(const OpticsScene& scene, double range[2]);
  ///@}

private:
  TransferFunctionTexture Opacity;
  TransferFunctionTexture Color;
};

#endif
