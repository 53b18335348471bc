// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The table of a lighting transfer function on the GPU: ka, kd, ks and the difference of classified
// densities, by (S1, S2).

#ifndef LightingTableTexture_h
#define LightingTableTexture_h

#include "TermTexture.h"

#include <vector>

class vtkLightingTransferFunction;
class vtkOpenGLRenderWindow;
class vtkPiecewiseFunction;
class vtkShaderProgram;
class vtkWindow;

class LightingTableTexture
{
public:
  /** What a table depends on. */
  struct Request
  {
    vtkLightingTransferFunction* Function;
    vtkPiecewiseFunction* Density; // may be null: no difference
    double Range[2];               // the scalars that the coordinates 0 and 1 stand for
    int Size;
    int Bits; // per number: 16 or 32
  };

  /** Uploads what has changed. */
  void Update(const Request& request, vtkOpenGLRenderWindow* window);
  void SetUniforms(vtkShaderProgram* program);
  void Unbind() { this->Texture.Unbind(); }
  void Release(vtkWindow* window) { this->Texture.Release(window); }
  std::size_t GetMemorySize() const;

private:
  void Upload(const Request& request, vtkOpenGLRenderWindow* window);

  TermTexture Texture;
  float LargestDifference = 0.0F;
  Request Uploaded = {};
  vtkMTimeType UploadedTime = 0;
};

#endif
