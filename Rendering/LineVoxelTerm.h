// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Anisotropic voxels [Schussman2004] in the ray caster: an image of vtkAnisotropicLineVoxelizer is drawn as lines.

#ifndef LineVoxelTerm_h
#define LineVoxelTerm_h

#include "LineEvaluation.h"
#include "OpticsTerm.h"

#include "vtkType.h"

class vtkImageData;

class LineVoxelTerm : public OpticsTerm
{
public:
  const char* GetName() const override { return "Lines"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetMemorySize() const override;

private:
  bool Upload(const OpticsScene& scene, vtkImageData* image);
  void CheckLights(const OpticsScene& scene, vtkImageData* image) const;

  LineTextures Lines;
  LineEvaluation Evaluation;
  vtkImageData* Uploaded = nullptr;
  vtkMTimeType UploadedTime = 0;
  int UploadedBits = 0;
};

#endif
