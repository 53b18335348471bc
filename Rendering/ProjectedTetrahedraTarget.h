// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What projected tetrahedra are drawn on: a picture in float, since thousands of faint layers would
// drown in the rounding of 8 bits, and the depth of the opaque geometry as a texture.

#ifndef ProjectedTetrahedraTarget_h
#define ProjectedTetrahedraTarget_h

#include "vtkNew.h"

#include <memory>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class ProjectedTetrahedraTarget
{
public:
  ProjectedTetrahedraTarget();
  ~ProjectedTetrahedraTarget();

  // Of the current viewport: copies its depth, and binds an empty picture of its size.
  bool Begin(vtkOpenGLRenderWindow* window);

  // Composites the picture onto the framebuffer that was bound before Begin().
  void End();

  vtkTextureObject* GetOpaqueDepth() const { return this->Depth; }

  void Release(vtkWindow* window);

private:
  void Allocate();
  void CopyDepth();

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Picture;
  vtkNew<vtkTextureObject> Depth;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkOpenGLRenderWindow* Window = nullptr;
  int DepthFormat = 0;
  int Viewport[4] = { 0, 0, 0, 0 };
};

#endif
