// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// One image of anisotropic voxels in a frame: what is uploaded when it has changed, and evaluated when the view has.

#ifndef LineVolume_h
#define LineVolume_h

#include "LineEvaluation.h"
#include "OpticsScene.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkImageData;
class vtkShaderProgram;

class LineVolume
{
public:
  /** What is wrong with the image, and what to do about it; empty where it can be drawn. */
  std::string Update(vtkImageData* image, const OpticsScene& scene);

  bool IsEmpty() const { return this->Lines.AtlasSize.x == 0; }

  /** Data space to voxels, from the corner of the first one. */
  glm::dmat4 GetDataToVoxels() const { return this->DataToVoxels; }

  /** The least colour of all line types: what they have without lights, or a part of it. */
  glm::vec3 GetLeastColor() const;

  /** name: the beginning of the uniforms' names. */
  void SetUniforms(const std::string& name, vtkShaderProgram* program);
  void UnbindTextures();
  void Release(vtkWindow* window);
  std::size_t GetMemorySize() const;

private:
  std::string Upload(vtkImageData* image, int bits, vtkOpenGLRenderWindow* window);
  LineView ViewOf(const OpticsScene& scene) const;

  LineTextures Lines;
  LineEvaluation Evaluation;
  glm::dmat4 DataToVoxels = glm::dmat4(1.0);
  vtkWeakPointer<vtkImageData> Uploaded;
  vtkMTimeType UploadedTime = 0;
  int UploadedBits = 0;
};

#endif
