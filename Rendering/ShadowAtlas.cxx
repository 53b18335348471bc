// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShadowAtlas.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <algorithm>

namespace
{
unsigned int InternalFormat(int bits)
{
  return bits == 8 ? GL_R8 : (bits == 16 ? GL_R16F : GL_R32F);
}
}

//------------------------------------------------------------------------------
bool ShadowAtlas::Allocate(vtkOpenGLRenderWindow* window, const std::vector<Triple>& sizes, int bits)
{
  this->New = false;
  if (this->Texture.IsAlive(window) && this->Sizes == sizes && this->Bits == bits)
  {
    return true;
  }
  this->Release(window);
  this->Sizes = sizes;
  this->Bits = bits;
  this->New = true;
  vtkTextureObject* texture = this->Texture.Renew(window);
  if (!this->Arrange(vtkTextureObject::GetMaximumTextureSize3D(window)))
  {
    return false;
  }
  texture->SetInternalFormat(InternalFormat(bits));
  this->Texture.Interpolate();
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  const auto& extent = this->Extent;
  return texture->Create3DFromRaw(extent[0], extent[1], extent[2], 1, VTK_FLOAT, nullptr);
}

//------------------------------------------------------------------------------
// One behind the other along z, and the next pile beside it on x where this one is as high as can be.
bool ShadowAtlas::Arrange(int largestSize)
{
  this->Firsts.clear();
  Triple first = { 0, 0, 0 };
  Triple extent = { 0, 0, 0 };
  for (const Triple& size : this->Sizes)
  {
    if (first[2] > 0 && first[2] + size[2] > largestSize)
    {
      first = { extent[0], 0, 0 };
    }
    this->Firsts.push_back(first);
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[axis] = std::max(extent[axis], first[axis] + size[axis]);
    }
    first[2] += size[2];
  }
  this->Extent = extent;
  return *std::min_element(extent.begin(), extent.end()) > 0 &&
    *std::max_element(extent.begin(), extent.end()) <= largestSize;
}

//------------------------------------------------------------------------------
void ShadowAtlas::Copy(int grid, vtkTextureObject* source)
{
  vtkOpenGLState* state = this->Texture->GetContext()->GetState();
  const Triple& first = this->Firsts[grid];
  const Triple& size = this->Sizes[grid];
  state->PushFramebufferBindings();
  unsigned int framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  this->Texture->Activate();
  for (int slice = 0; slice < size[2]; ++slice)
  {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, source->GetHandle(), 0, slice);
    state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
    glCopyTexSubImage3D(GL_TEXTURE_3D, 0, first[0], first[1], first[2] + slice, 0, 0, size[0], size[1]);
  }
  this->Texture->Deactivate();
  state->PopFramebufferBindings();
  glDeleteFramebuffers(1, &framebuffer);
}

//------------------------------------------------------------------------------
std::size_t ShadowAtlas::GetMemorySize() const
{
  const auto& extent = this->Extent;
  return this->Texture ? std::size_t(1) * extent[0] * extent[1] * extent[2] * this->Bits / 8 : 0;
}

//------------------------------------------------------------------------------
void ShadowAtlas::Release(vtkWindow* window)
{
  this->Texture.Release(window);
  this->Sizes.clear();
  this->Firsts.clear();
  this->Extent = {};
}
