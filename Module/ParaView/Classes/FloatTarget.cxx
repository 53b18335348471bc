// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FloatTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

namespace
{
// The volume mapper copies the depths into a texture of such a format as the window's are.
const int DepthBits = 32;
}

//------------------------------------------------------------------------------
void FloatTarget::Begin(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  const int* size = window->GetActualSize();
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  if (this->Framebuffer->GetNumberOfColorAttachments() == 0)
  {
    this->Framebuffer->PopulateFramebuffer(
      size[0], size[1], true, 1, VTK_FLOAT, true, DepthBits, 0, window->GetStencilCapable() != 0);
  }
  this->Framebuffer->Bind();
  this->Framebuffer->Resize(size[0], size[1]);
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->ActivateReadBuffer(0);
  state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

//------------------------------------------------------------------------------
void FloatTarget::End(vtkOpenGLRenderWindow* window, int width, int height, float* pixels)
{
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateReadBuffer(0);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels);
  window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void FloatTarget::Release(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
}
