// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SweepTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <string>

namespace
{
const float Light[4] = { 1.0F, 1.0F, 1.0F, 1.0F };

// Each slice rounds what passed the one before: beyond this many a half float's last digit adds up.
const int LargestNumberOfHalfSlices = 256;

int BitsOfPassed(const SweepTarget::Format& format)
{
  return format.Size[2] > LargestNumberOfHalfSlices ? 32 : format.Bits;
}

unsigned int InternalFormat(int components, int bits)
{
  const unsigned int one = bits == 8 ? GL_R8 : (bits == 16 ? GL_R16F : GL_R32F);
  const unsigned int four = bits == 8 ? GL_RGBA8 : (bits == 16 ? GL_RGBA16F : GL_RGBA32F);
  return components == 1 ? one : four;
}
}

// What the mapper has set for its own drawing.
class SweepTarget::KeptState
{
public:
  explicit KeptState(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , ColorMask(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
    , Scissor(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , StencilTest(state, GL_STENCIL_TEST)
  {
    state->PushFramebufferBindings();
    for (const unsigned int capability :
      { GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST })
    {
      state->SetEnumState(capability, false);
    }
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  ~KeptState() { this->State->PopFramebufferBindings(); }

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
};

//------------------------------------------------------------------------------
SweepTarget::SweepTarget() = default;

//------------------------------------------------------------------------------
SweepTarget::~SweepTarget() = default;

//------------------------------------------------------------------------------
bool SweepTarget::Allocate(vtkOpenGLRenderWindow* window, const Format& format)
{
  this->Window = window;
  if (this->Visibility.IsAlive(window) && this->Current == format)
  {
    return true;
  }
  this->Release(window);
  this->Current = format;
  this->Time.Modified();
  const auto& size = format.Size;
  const int components = format.Directions == 1 ? 1 : 4;
  vtkTextureObject* visibility = this->Visibility.Renew(window);
  const int kept = format.IsByDirection ? 4 : 1;
  visibility->SetInternalFormat(InternalFormat(kept, format.Bits));
  this->Visibility.Interpolate();
  visibility->SetWrapR(vtkTextureObject::ClampToEdge);
  bool isAllocated = visibility->Create3DFromRaw(
    size[0], size[1], size[2] * format.GetNumberOfLayers(), kept, VTK_FLOAT, nullptr);
  for (Textures& textures : this->Passed)
  {
    for (int i = 0; i < format.GetNumberOfTextures(); ++i)
    {
      vtkTextureObject* passed = textures[i].Renew(window);
      passed->SetInternalFormat(InternalFormat(components, BitsOfPassed(format)));
      textures[i].Interpolate();
      isAllocated &= passed->Create2DFromRaw(size[0], size[1], components, VTK_FLOAT, nullptr);
    }
  }
  glGenFramebuffers(1, &this->Framebuffer);
  return isAllocated && this->IsComplete();
}

//------------------------------------------------------------------------------
bool SweepTarget::IsComplete()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  this->Attach(0, this->Passed[0]);
  const bool isComplete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  state->PopFramebufferBindings();
  return isComplete;
}

//------------------------------------------------------------------------------
void SweepTarget::Attach(int slice, Textures& written)
{
  unsigned int buffers[2 * LargestNumberOfTextures];
  const int layers = this->Current.GetNumberOfLayers();
  const int textures = this->Current.GetNumberOfTextures();
  for (int i = 0; i < textures; ++i)
  {
    unsigned int* kept = buffers + 2 * i;
    unsigned int* passing = kept + 1;
    *kept = i < layers ? GL_COLOR_ATTACHMENT0 + 2 * i : GL_NONE;
    if (i < layers)
    {
      const int layer = slice + i * this->Current.Size[2];
      glFramebufferTextureLayer(GL_FRAMEBUFFER, *kept, this->Visibility->GetHandle(), 0, layer);
    }
    *passing = GL_COLOR_ATTACHMENT0 + 2 * i + 1;
    glFramebufferTexture2D(GL_FRAMEBUFFER, *passing, GL_TEXTURE_2D, written[i]->GetHandle(), 0);
  }
  glDrawBuffers(2 * textures, buffers);
}

//------------------------------------------------------------------------------
// Of what is attached, the textures of that many each: layers of the slice are the even ones.
void SweepTarget::FillWithLight(int first, int stride)
{
  for (int i = first; i < 2 * this->Current.GetNumberOfTextures(); i += stride)
  {
    glClearBufferfv(GL_COLOR, i, Light);
  }
}

//------------------------------------------------------------------------------
bool SweepTarget::IsWhole(const SweepRectangle& region) const
{
  return region == SweepRectangle{ { 0, 0 }, { this->Current.Size[0], this->Current.Size[1] } };
}

//------------------------------------------------------------------------------
void SweepTarget::Begin()
{
  vtkOpenGLState* state = this->Window->GetState();
  this->Kept = std::make_unique<KeptState>(state);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  state->vtkglViewport(0, 0, this->Current.Size[0], this->Current.Size[1]);
  glGenVertexArrays(1, &this->VertexArray);
  glBindVertexArray(this->VertexArray);
  // in front of the first slice nothing is hidden; but the slice itself may have been filled before
  this->Attach(0, this->Passed[1]);
  this->FillWithLight(1, 2);
}

//------------------------------------------------------------------------------
// The texture that is read is never the one that is drawn on.
void SweepTarget::DrawSlice(int slice, const SweepRectangle& region, vtkShaderProgram* program)
{
  Textures& read = this->Passed[(slice + 1) % 2];
  this->Attach(slice, this->Passed[slice % 2]);
  if (!this->IsWhole(region))
  {
    this->FillWithLight(0, 1);
  }
  if (region.IsEmpty())
  {
    return;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglScissor(
    region.Begin[0], region.Begin[1], region.End[0] - region.Begin[0], region.End[1] - region.Begin[1]);
  state->SetEnumState(GL_SCISSOR_TEST, true);
  for (int i = 0; i < this->Current.GetNumberOfTextures(); ++i)
  {
    read[i].Bind(("in_sweepPassed" + std::to_string(i)).c_str(), program);
  }
  glDrawArrays(GL_TRIANGLES, 0, 3);
  state->SetEnumState(GL_SCISSOR_TEST, false);
  for (TermTexture& texture : read)
  {
    texture.Unbind();
  }
}

//------------------------------------------------------------------------------
void SweepTarget::End()
{
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &this->VertexArray);
  this->Kept.reset();
}

//------------------------------------------------------------------------------
std::size_t SweepTarget::GetMemorySize() const
{
  if (!this->Visibility)
  {
    return 0;
  }
  const auto& size = this->Current.Size;
  const std::size_t froxels = std::size_t(1) * size[0] * size[1];
  const int channels = this->Current.Directions == 1 ? 1 : 4 * this->Current.GetNumberOfTextures();
  const std::size_t passed = 2 * froxels * channels;
  const int kept = this->Current.IsByDirection ? channels : 1;
  return (froxels * size[2] * kept * this->Current.Bits + passed * BitsOfPassed(this->Current)) / 8;
}

//------------------------------------------------------------------------------
void SweepTarget::Release(vtkWindow* window)
{
  if (this->Visibility && this->Framebuffer != 0)
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
    this->Framebuffer = 0;
  }
  this->Visibility.Release(window);
  for (Textures& textures : this->Passed)
  {
    for (TermTexture& texture : textures)
    {
      texture.Release(window);
    }
  }
  this->Current = {};
}
