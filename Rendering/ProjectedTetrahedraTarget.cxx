// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProjectedTetrahedraTarget.h"

#include "ProjectedTetrahedraCopy.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

namespace
{
// A blit of depth demands the same format on both sides.
const int DepthAndStencil = -1;

int GetAttachment(unsigned int attachment, unsigned int parameter)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, attachment, parameter, &value);
  return value;
}

// DepthAndStencil, or a vtkTextureObject::DepthFormat.
int GetBoundDepthFormat()
{
  GLint framebuffer = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
  const unsigned int depth = framebuffer == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const unsigned int stencil = framebuffer == 0 ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  if (GetAttachment(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE)
  {
    return DepthAndStencil;
  }
  const bool hasDepth = GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
  if (hasDepth && GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return vtkTextureObject::Float32;
  }
  const int bits = !hasDepth ? 32 : GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  return bits == 16 ? vtkTextureObject::Fixed16
                    : (bits == 24 ? vtkTextureObject::Fixed24 : vtkTextureObject::Fixed32);
}
}

//------------------------------------------------------------------------------
ProjectedTetrahedraTarget::ProjectedTetrahedraTarget() = default;

//------------------------------------------------------------------------------
ProjectedTetrahedraTarget::~ProjectedTetrahedraTarget() = default;

//------------------------------------------------------------------------------
void ProjectedTetrahedraTarget::Allocate()
{
  const unsigned int width = this->Viewport[2], height = this->Viewport[3];
  const bool isAlive = this->Picture->GetContext() == this->Window && this->Picture->GetHandle() != 0;
  const int depthFormat = GetBoundDepthFormat();
  if (isAlive && this->Picture->GetWidth() == width && this->Picture->GetHeight() == height &&
    depthFormat == this->DepthFormat)
  {
    return;
  }
  this->Release(this->Window);
  this->Framebuffer->SetContext(this->Window);
  for (vtkTextureObject* texture : { this->Picture.GetPointer(), this->Depth.GetPointer() })
  {
    texture->SetContext(this->Window);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  this->Picture->Allocate2D(width, height, 4, VTK_FLOAT);
  this->DepthFormat = depthFormat;
  depthFormat == DepthAndStencil ? this->Depth->AllocateDepthStencil(width, height)
                                 : this->Depth->AllocateDepth(width, height, depthFormat);
}

//------------------------------------------------------------------------------
// The draw framebuffer is ours, the read framebuffer the one that was bound. Where that has no depth,
// nothing is opaque.
void ProjectedTetrahedraTarget::CopyDepth()
{
  const int* port = this->Viewport;
  vtkOpenGLState* state = this->Window->GetState();
  this->Framebuffer->AddDepthAttachment(this->Depth);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  state->vtkglBlitFramebuffer(port[0], port[1], port[0] + port[2], port[1] + port[3], 0, 0, port[2], port[3],
    GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  this->Framebuffer->RemoveDepthAttachment();
}

//------------------------------------------------------------------------------
bool ProjectedTetrahedraTarget::Begin(vtkOpenGLRenderWindow* window)
{
  this->Window = window;
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
  if (this->Viewport[2] < 1 || this->Viewport[3] < 1)
  {
    return false;
  }
  this->Allocate();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->Framebuffer->AddColorAttachment(0, this->Picture);
  this->Framebuffer->ActivateDrawBuffer(0);
  state->vtkglScissor(0, 0, this->Viewport[2], this->Viewport[3]);
  this->CopyDepth();
  state->vtkglViewport(0, 0, this->Viewport[2], this->Viewport[3]);
  state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  return true;
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraTarget::End()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PopFramebufferBindings();
  const int* port = this->Viewport;
  state->vtkglViewport(port[0], port[1], port[2], port[3]);
  state->vtkglScissor(port[0], port[1], port[2], port[3]);
  if (this->Quad)
  {
    this->Window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  else
  {
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(this->Window, nullptr, ProjectedTetrahedraCopy, nullptr);
  }
  this->Picture->Activate();
  this->Quad->Program->SetUniformi("in_picture", this->Picture->GetTextureUnit());
  this->Quad->Render();
  this->Picture->Deactivate();
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraTarget::Release(vtkWindow* window)
{
  this->Quad.reset();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Picture->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
}
