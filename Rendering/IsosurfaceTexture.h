// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The isosurfaces of a scene on the GPU, sorted by value.

#ifndef IsosurfaceTexture_h
#define IsosurfaceTexture_h

#include "OpticsScene.h"
#include "TermTexture.h"

#include <vector>

class vtkShaderProgram;
class vtkWindow;

class IsosurfaceTexture
{
public:
  /** The width that every OpenGL 3.2 has. */
  static constexpr int LargestNumber = 1024;

  /** After VTK has loaded the volume. Uploads what has changed. */
  void Update(const OpticsScene& scene);
  void SetUniforms(vtkShaderProgram* program);
  void Unbind() { this->Texture.Unbind(); }
  void Release(vtkWindow* window) { this->Texture.Release(window); }
  std::size_t GetMemorySize() const;

private:
  TermTexture Texture;
  std::vector<float> Texels;
};

#endif
