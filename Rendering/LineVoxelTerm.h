// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Anisotropic voxels [Schussman2004] in the ray caster: an image of vtkAnisotropicLineVoxelizer is drawn as lines,
// and a second one in place of a part of it.

#ifndef LineVoxelTerm_h
#define LineVoxelTerm_h

#include "FrameProvider.h"
#include "LineVolume.h"
#include "OpticsTerm.h"

class LineVoxelTerm : public OpticsTerm
{
public:
  FrameProvider::Connection BlockInput;

  /** Up to date; null: none. */
  vtkImageData* GetBlock() const;

  const char* GetName() const override { return "Lines"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetMemorySize() const override;

private:
  void PrepareBlock(const OpticsScene& scene);

  LineVolume Lines;
  LineVolume Block;
  bool HasBlock = false;
};

#endif
