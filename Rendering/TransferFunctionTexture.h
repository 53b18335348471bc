// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A transfer function on the GPU as it is: opacity is not corrected for the step, as VTK's own table is,
// so that what is made of it does not depend on the step.

#ifndef TransferFunctionTexture_h
#define TransferFunctionTexture_h

#include "TermTexture.h"

#include <string>

class vtkColorTransferFunction;
class vtkOpenGLRenderWindow;
class vtkPiecewiseFunction;
class vtkShaderProgram;
class vtkWindow;

class TransferFunctionTexture
{
public:
  ///@{
  /** range: the scalars that VTK's coordinate 0 and 1 stand for. */
  void Update(vtkPiecewiseFunction* opacity, const double range[2], vtkOpenGLRenderWindow* window);
  void Update(vtkColorTransferFunction* color, const double range[2], vtkOpenGLRenderWindow* window);
  ///@}

  /** The sampler of this name, and a vec2 of this name with "Code" behind it. */
  void SetUniforms(const std::string& name, vtkShaderProgram* program);
  void Unbind() { this->Texture.Unbind(); }
  void Release(vtkWindow* window) { this->Texture.Release(window); }
  std::size_t GetMemorySize() const;

private:
  template <typename Function>
  void UpdateTable(
    Function* function, const double range[2], int width, int components, vtkOpenGLRenderWindow* window);

  TermTexture Texture;
  vtkObject* Source = nullptr;
  vtkMTimeType SourceTime = 0;
  double Range[2] = { 0.0, 0.0 };
};

#endif
