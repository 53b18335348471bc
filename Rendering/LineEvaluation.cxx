// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineEvaluation.h"

#include "StandaloneShaders.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <algorithm>
#include <utility>

using volumeoptics::LineScale;

namespace
{
std::vector<double> KeyOf(
  const LineView& view, const std::vector<LineScale>& scales, vtkPiecewiseFunction* function, int bits)
{
  std::vector<double> key = { view.Position.x, view.Position.y, view.Position.z, view.ToEye.x, view.ToEye.y,
    view.ToEye.z, view.IsParallel ? 1.0 : 0.0, static_cast<double>(bits),
    function ? static_cast<double>(function->GetMTime()) : -1.0 };
  for (const LineScale& scale : scales)
  {
    key.push_back(scale.Radius);
    key.push_back(scale.Opacity);
  }
  return key;
}

void SetVector(vtkShaderProgram* program, const char* name, const glm::vec3& vector)
{
  program->SetUniform3f(name, &vector.x);
}

template <class Textures>
void BindAll(const Textures& textures, vtkShaderProgram* program)
{
  for (const auto& [name, texture] : textures)
  {
    if (*texture)
    {
      texture->Bind(name, program);
    }
  }
}

template <class Textures>
void UnbindAll(const Textures& textures)
{
  for (const auto& [name, texture] : textures)
  {
    texture->Unbind();
  }
}

void SetView(vtkShaderProgram* program, const LineView& view)
{
  SetVector(program, "in_eye", view.Position);
  SetVector(program, "in_toEye", view.ToEye);
  program->SetUniformi("in_isParallel", view.IsParallel ? 1 : 0);
}

void SetTypes(vtkShaderProgram* program, const LineTextures& lines, const std::vector<LineScale>& scales)
{
  std::vector<glm::vec3> factors, least, largest;
  for (std::size_t i = 0; i < lines.Types.size(); ++i)
  {
    const LineTextures::Type& type = lines.Types[i];
    factors.emplace_back(scales[i].Radius, scales[i].Opacity, type.Scale);
    least.push_back(type.LeastColor);
    largest.push_back(type.LargestColor);
  }
  const auto set = [&](const char* name, const std::vector<glm::vec3>& values) {
    program->SetUniform3fv(
      name, static_cast<int>(values.size()), reinterpret_cast<const float(*)[3]>(values.data()));
  };
  set("in_scales", factors);
  set("in_leastColors", least);
  set("in_largestColors", largest);
}
}

//------------------------------------------------------------------------------
LineEvaluation::LineEvaluation()
{
  this->Identity->AddPoint(0.0, 0.0);
  this->Identity->AddPoint(1.0, 1.0);
}

//------------------------------------------------------------------------------
LineEvaluation::~LineEvaluation() = default;

//------------------------------------------------------------------------------
void LineEvaluation::Update(LineTextures& lines, const LineView& view, const std::vector<LineScale>& scales,
  vtkPiecewiseFunction* function, int bits, vtkOpenGLRenderWindow* window)
{
  const std::vector<double> key = KeyOf(view, scales, function, bits);
  if (this->Atlas.IsAlive(window) && key == this->Evaluated)
  {
    return;
  }
  this->Window = window;
  const double range[2] = { 0.0, 1.0 };
  this->Function.Update(function ? function : this->Identity.Get(), range, window);
  this->Allocate(lines, std::max(bits, 16), window);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->Evaluate(lines, view, scales, function != nullptr);
  this->Place(lines);
  state->PopFramebufferBindings();
  this->Evaluated = key;
}

//------------------------------------------------------------------------------
void LineEvaluation::Allocate(const LineTextures& lines, int bits, vtkOpenGLRenderWindow* window)
{
  const auto fits = [&](const TermTexture& texture, const glm::ivec2& size) {
    return texture.IsAlive(window) && glm::ivec2(texture->GetWidth(), texture->GetHeight()) == size;
  };
  const glm::ivec2 list(lines.Voxels->GetWidth(), lines.Voxels->GetHeight());
  if (bits != this->Bits || !fits(this->Atlas, lines.AtlasSize) || !fits(this->Looks, list))
  {
    this->Bits = bits;
    this->AllocateTarget(this->Atlas, lines.AtlasSize);
    this->Atlas.Interpolate();
    this->AllocateTarget(this->Looks, list);
  }
}

//------------------------------------------------------------------------------
void LineEvaluation::AllocateTarget(TermTexture& target, const glm::ivec2& size)
{
  vtkTextureObject* texture = target.Renew(this->Window);
  texture->SetInternalFormat(this->Bits == 32 ? GL_RGBA32F : GL_RGBA16F);
  texture->SetFormat(GL_RGBA);
  texture->SetDataType(GL_FLOAT);
  texture->Allocate2D(size.x, size.y, 4, VTK_FLOAT);
}

//------------------------------------------------------------------------------
void LineEvaluation::Evaluate(
  LineTextures& lines, const LineView& view, const std::vector<LineScale>& scales, bool mapsOpacity)
{
  vtkShaderProgram* program = this->MakeProgramReady(LineEvaluationFragmentShader(
    lines.MaximumOrder, static_cast<int>(lines.Types.size()), static_cast<bool>(lines.Ranges)));
  SetVector(program, "in_voxelSize", lines.Grid.Voxel);
  program->SetUniformi("in_numberOfVoxels", lines.NumberOfVoxels);
  SetView(program, view);
  SetTypes(program, lines, scales);
  this->Function.SetUniforms("in_opacityFunction", program);
  program->SetUniformi("in_mapsOpacity", mapsOpacity ? 1 : 0);
  const std::pair<const char*, TermTexture*> textures[] = { { "in_voxels", &lines.Voxels },
    { "in_starts", &lines.Starts }, { "in_harmonics", &lines.Harmonics },
    { "in_coefficients", &lines.Coefficients }, { "in_ranges", &lines.Ranges } };
  BindAll(textures, program);
  this->Draw(this->Looks);
  UnbindAll(textures);
  this->Function.Unbind();
}

//------------------------------------------------------------------------------
// A voxel at the face of a brick has a texel in each of the tiles there.
void LineEvaluation::Place(LineTextures& lines)
{
  vtkShaderProgram* program = this->MakeProgramReady(LinePlacementFragmentShader());
  const std::pair<const char*, TermTexture*> textures[] = { { "in_ranks", &lines.Ranks },
    { "in_firstSources", &lines.FirstSources }, { "in_sources", &lines.Sources },
    { "in_evaluated", &this->Looks } };
  BindAll(textures, program);
  this->Draw(this->Atlas);
  UnbindAll(textures);
}

//------------------------------------------------------------------------------
vtkShaderProgram* LineEvaluation::MakeProgramReady(const std::string& fragment)
{
  return this->Window->GetShaderCache()->ReadyShaderProgram(
    LineEvaluationVertexShader().c_str(), fragment.c_str(), "");
}

//------------------------------------------------------------------------------
void LineEvaluation::Draw(TermTexture& target)
{
  this->Framebuffer->AddColorAttachment(0, target.Get());
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Window->GetState()->vtkglViewport(0, 0, target->GetWidth(), target->GetHeight());
  this->NoArrays->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->NoArrays->Release();
}

//------------------------------------------------------------------------------
void LineEvaluation::Release(vtkWindow* window)
{
  this->NoArrays->ReleaseGraphicsResources();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Function.Release(window);
  this->Atlas.Release(window);
  this->Looks.Release(window);
  this->Evaluated.clear();
}

//------------------------------------------------------------------------------
std::size_t LineEvaluation::GetMemorySize() const
{
  std::size_t texels = 0;
  for (const TermTexture* texture : { &this->Atlas, &this->Looks })
  {
    texels += *texture ? std::size_t(1) * (*texture)->GetWidth() * (*texture)->GetHeight() : 0;
  }
  return texels * this->Bits / 2 + this->Function.GetMemorySize();
}
