// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A texture that a term owns: it lives in one window, and holds a texture unit only while it is bound.

#ifndef TermTexture_h
#define TermTexture_h

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class TermTexture
{
public:
  /** A new window may have the address of one that took its textures along. */
  bool IsAlive(vtkOpenGLRenderWindow* window) const;

  /** A new one in the window, still without texels, in place of what was there. */
  vtkTextureObject* Renew(vtkOpenGLRenderWindow* window);

  /** Linear between its texels, and the outermost ones beyond. */
  void Interpolate();

  void Bind(const char* sampler, vtkShaderProgram* program);
  void Unbind();
  void Release(vtkWindow* window);

  explicit operator bool() const { return this->Texture != nullptr; }
  vtkTextureObject* operator->() const { return this->Texture; }
  vtkTextureObject* Get() const { return this->Texture; }

private:
  vtkSmartPointer<vtkTextureObject> Texture;
};

#endif
