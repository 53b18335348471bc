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

#include <iterator>

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
  const bool isNew = this->Allocate(lines.AtlasSize, bits, window);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->Framebuffer->AddColorAttachment(0, this->Atlas.Get());
  this->Framebuffer->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, this->Atlas->GetWidth(), this->Atlas->GetHeight());
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (isNew)
  {
    state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  state->vtkglPointSize(1.0F);
  this->Draw(lines, view, scales, function != nullptr);
  state->PopFramebufferBindings();
  this->Evaluated = key;
}

//------------------------------------------------------------------------------
bool LineEvaluation::Allocate(const glm::ivec2& size, int bits, vtkOpenGLRenderWindow* window)
{
  const bool fits = this->Atlas.IsAlive(window) && bits == this->Bits &&
    glm::ivec2(this->Atlas->GetWidth(), this->Atlas->GetHeight()) == size;
  if (fits)
  {
    return false;
  }
  this->Bits = bits;
  vtkTextureObject* texture = this->Atlas.Renew(window);
  texture->SetInternalFormat(bits == 32 ? GL_RGBA32F : GL_RGBA16F);
  texture->SetFormat(GL_RGBA);
  texture->SetDataType(GL_FLOAT);
  this->Atlas.Interpolate();
  texture->Allocate2D(size.x, size.y, 4, VTK_FLOAT);
  return true;
}

//------------------------------------------------------------------------------
void LineEvaluation::Draw(
  LineTextures& lines, const LineView& view, const std::vector<LineScale>& scales, bool mapsOpacity)
{
  this->MakeProgramReady(lines);
  vtkShaderProgram* program = this->Program;
  this->SetSizes(lines);
  this->SetView(view);
  this->SetTypes(lines, scales);
  this->Function.SetUniforms("in_opacityFunction", program);
  program->SetUniformi("in_mapsOpacity", mapsOpacity ? 1 : 0);
  TermTexture* const textures[] = { &lines.Points, &lines.Voxels, &lines.Starts, &lines.Harmonics,
    &lines.Coefficients };
  const char* const names[] = { "in_points", "in_voxels", "in_starts", "in_harmonics", "in_coefficients" };
  for (std::size_t i = 0; i < std::size(textures); ++i)
  {
    textures[i]->Bind(names[i], program);
  }
  this->NoArrays->Bind();
  glDrawArrays(GL_POINTS, 0, lines.NumberOfPoints);
  this->NoArrays->Release();
  for (TermTexture* texture : textures)
  {
    texture->Unbind();
  }
  this->Function.Unbind();
}

//------------------------------------------------------------------------------
void LineEvaluation::MakeProgramReady(const LineTextures& lines)
{
  const std::string vertex =
    LineEvaluationVertexShader(lines.MaximumOrder, static_cast<int>(lines.Types.size()));
  const std::string fragment = LineEvaluationFragmentShader();
  this->Program = this->Window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
}

//------------------------------------------------------------------------------
void LineEvaluation::SetSizes(const LineTextures& lines)
{
  vtkShaderProgram* program = this->Program;
  SetVector(program, "in_voxelSize", lines.Grid.Voxel);
  const glm::vec2 atlasSize = lines.AtlasSize;
  program->SetUniform2f("in_atlasSize", &atlasSize.x);
  program->SetUniformi("in_numberOfVoxels", lines.NumberOfVoxels);
}

//------------------------------------------------------------------------------
void LineEvaluation::SetView(const LineView& view)
{
  vtkShaderProgram* program = this->Program;
  SetVector(program, "in_eye", view.Position);
  SetVector(program, "in_toEye", view.ToEye);
  program->SetUniformi("in_isParallel", view.IsParallel ? 1 : 0);
}

//------------------------------------------------------------------------------
void LineEvaluation::SetTypes(const LineTextures& lines, const std::vector<LineScale>& scales)
{
  std::vector<glm::vec3> factors, least, largest;
  for (std::size_t i = 0; i < lines.Types.size(); ++i)
  {
    const LineTextures::Type& type = lines.Types[i];
    factors.emplace_back(scales[i].Radius, scales[i].Opacity, type.Scale);
    least.push_back(type.LeastColor);
    largest.push_back(type.LargestColor);
  }
  vtkShaderProgram* program = this->Program;
  const auto set = [&](const char* name, const std::vector<glm::vec3>& values) {
    program->SetUniform3fv(
      name, static_cast<int>(values.size()), reinterpret_cast<const float(*)[3]>(values.data()));
  };
  set("in_scales", factors);
  set("in_leastColors", least);
  set("in_largestColors", largest);
}

//------------------------------------------------------------------------------
void LineEvaluation::Release(vtkWindow* window)
{
  this->NoArrays->ReleaseGraphicsResources();
  this->Program = nullptr;
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Function.Release(window);
  this->Atlas.Release(window);
  this->Evaluated.clear();
}

//------------------------------------------------------------------------------
std::size_t LineEvaluation::GetMemorySize() const
{
  const std::size_t texels =
    this->Atlas ? std::size_t(1) * this->Atlas->GetWidth() * this->Atlas->GetHeight() : 0;
  return texels * this->Bits / 2 + this->Function.GetMemorySize();
}
