// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A scalar opacity function on the GPU, per unit distance: not corrected for the step, as VTK's own
// table is, so that derivatives of the optical depth do not depend on the step.

#ifndef ScalarOpacityTexture_h
#define ScalarOpacityTexture_h

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkPiecewiseFunction;
class vtkShaderProgram;
class vtkWindow;

class ScalarOpacityTexture
{
public:
  /** range: the scalars that VTK's coordinate 0 and 1 stand for. */
  void Update(vtkPiecewiseFunction* opacity, const double range[2], vtkOpenGLRenderWindow* window);
  void SetUniforms(vtkShaderProgram* program);
  void Unbind();
  void Release(vtkWindow* window);
  std::size_t GetMemorySize() const;

private:
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkPiecewiseFunction* Source = nullptr;
  vtkMTimeType SourceTime = 0;
  double Range[2] = { 0.0, 0.0 };
};

#endif
