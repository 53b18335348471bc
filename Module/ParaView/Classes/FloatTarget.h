// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where a process draws its picture with numbers of 32 bits, beyond 1 as well.

#ifndef FloatTarget_h
#define FloatTarget_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"

class vtkOpenGLRenderWindow;
class vtkWindow;

class FloatTarget
{
public:
  /** What is drawn from now on goes here, on black without opacity. */
  void Begin(vtkOpenGLRenderWindow* window);

  /** Copies the lower left part of what was drawn, four numbers a pixel, and goes back to the window's own target. */
  void End(vtkOpenGLRenderWindow* window, int width, int height, float* pixels);

  void Release(vtkWindow* window);

private:
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};

#endif
