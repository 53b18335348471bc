// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProjectedTetrahedraPainter.h"

#include "StandaloneShaders.h"
#include "DataSpaceClassification.h"
#include "TetrahedraVertices.h"
#include "vtkPreIntegratedTable.h"

#include "vtkCamera.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <string>

namespace
{
void SetNearest(vtkTextureObject* texture)
{
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}
}

//------------------------------------------------------------------------------
ProjectedTetrahedraPainter::ProjectedTetrahedraPainter() = default;

//------------------------------------------------------------------------------
ProjectedTetrahedraPainter::~ProjectedTetrahedraPainter() = default;

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::SetVertices(const TetrahedraVertices* vertices)
{
  this->Vertices = vertices;
  this->AreVerticesUploaded = false;
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::SetClassification(const DataSpaceClassification* classification)
{
  this->Classification = classification;
  this->IsClassificationUploaded = false;
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::Draw(vtkRenderer* renderer, vtkVolume* volume,
  const std::vector<unsigned int>& indices, const ProgramCallback& beforeDrawing)
{
  this->Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blending(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglScissor scissor(state);
  if (!this->Target.Begin(this->Window))
  {
    return;
  }
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->Upload();
  this->MakeProgramReady();
  this->SetView(renderer, volume);
  this->BindTextures(this->Triangles.Program);
  beforeDrawing(this->Triangles.Program);
  this->DrawTriangles(indices);
  this->UnbindTextures();
  this->Target.End();
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::DrawTriangles(const std::vector<unsigned int>& indices)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(this->IsMirrored ? GL_BACK : GL_FRONT);
  this->BindVertices();
  this->Triangles.IBO->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  this->Triangles.IBO->Bind();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  this->Triangles.IBO->Release();
  this->Triangles.VAO->Release();
  state->vtkglCullFace(GL_BACK);
  state->vtkglDisable(GL_CULL_FACE);
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::Upload()
{
  if (!this->AreVerticesUploaded)
  {
    this->Buffer->Upload(this->Vertices->GetValues(), vtkOpenGLBufferObject::ArrayBuffer);
    this->AreVerticesUploaded = true;
  }
  if (!this->IsClassificationUploaded)
  {
    this->UploadTable();
    this->UploadIsosurfaces();
    this->IsClassificationUploaded = true;
  }
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::UploadTable()
{
  vtkPreIntegratedTable* source = this->Classification->GetTable();
  const unsigned int size = source->GetSize();
  this->Table->SetContext(this->Window);
  SetNearest(this->Table);
  this->Table->SetMinificationFilter(vtkTextureObject::Linear);
  this->Table->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Table->Create2DFromRaw(size, size, 4, VTK_FLOAT, const_cast<float*>(source->GetEntries()));
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::UploadIsosurfaces()
{
  const auto& surfaces = this->Classification->GetIsosurfaces();
  const std::size_t width = std::max<std::size_t>(surfaces.size(), 1);
  std::vector<float> texels(8 * width, 0.0F);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      texels[4 * i + channel] = static_cast<float>(surfaces[i].Color[channel]);
    }
    texels[4 * (width + i)] = static_cast<float>(surfaces[i].Value);
  }
  this->Isosurfaces->SetContext(this->Window);
  SetNearest(this->Isosurfaces);
  this->Isosurfaces->Create2DFromRaw(static_cast<unsigned int>(width), 2, 4, VTK_FLOAT, texels.data());
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::MakeProgramReady()
{
  vtkOpenGLShaderCache* cache = this->Window->GetShaderCache();
  const std::string fragment = this->GetFragmentShader();
  if (this->Triangles.Program && fragment == this->FragmentShader)
  {
    cache->ReadyShaderProgram(this->Triangles.Program);
    return;
  }
  const std::string vertex = ProjectedTetrahedraVertexShader();
  this->Triangles.Program = cache->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  this->Triangles.VAO->ShaderProgramChanged();
  this->FragmentShader = fragment;
}

//------------------------------------------------------------------------------
std::string ProjectedTetrahedraPainter::GetFragmentShader() const
{
  return ProjectedTetrahedraFragmentShader(
    this->Classification->GetSilhouette(), !this->Classification->GetIsosurfaces().empty());
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::BindVertices()
{
  const std::size_t stride = TetrahedraVertices::Stride * sizeof(float);
  this->Triangles.VAO->Bind();
  this->Buffer->Bind();
  const auto add = [&](const std::string& name, int offset, int components) {
    this->Triangles.VAO->AddAttributeArray(this->Triangles.Program, this->Buffer, name,
      offset * static_cast<int>(sizeof(float)), stride, VTK_FLOAT, components, false);
  };
  add("vertexMC", 0, 3);
  add("vertexScalars", TetrahedraVertices::ScalarsOffset, 4);
  for (int weight = 1; weight < 4; ++weight)
  {
    add("vertexWeightGradient" + std::to_string(weight),
      TetrahedraVertices::GradientsOffset + 3 * (weight - 1), 3);
  }
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::SetView(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  vtkMatrix4x4* worldToView = nullptr; // VTK hands these out transposed, as OpenGL takes them
  vtkMatrix4x4* viewToDevice = nullptr;
  vtkMatrix4x4* worldToDevice = nullptr;
  vtkMatrix3x3* normals = nullptr;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToDevice, worldToDevice);
  vtkShaderProgram* program = this->Triangles.Program;
  program->SetUniformMatrix("in_viewToDevice", viewToDevice);
  const float depthCode[4] = { static_cast<float>(viewToDevice->GetElement(2, 2)),
    static_cast<float>(viewToDevice->GetElement(3, 2)), static_cast<float>(viewToDevice->GetElement(2, 3)),
    static_cast<float>(viewToDevice->GetElement(3, 3)) };
  program->SetUniform4f("in_depthCode", depthCode);
  program->SetUniformi("in_isParallel", camera->GetParallelProjection());
  program->SetUniformf("in_nearDistance", static_cast<float>(camera->GetClippingRange()[0]));
  this->SetModelToView(worldToView, volume->GetMatrix());
}

//------------------------------------------------------------------------------
// In double: neither far origins nor large or small worlds take digits from the vertices.
void ProjectedTetrahedraPainter::SetModelToView(vtkMatrix4x4* worldToView, vtkMatrix4x4* volumeToWorld)
{
  const double scale = this->Vertices->GetScale();
  vtkNew<vtkMatrix4x4> model;
  for (int row = 0; row < 3; ++row)
  {
    model->SetElement(row, row, scale);
    model->SetElement(row, 3, this->Vertices->GetCenter()[row]);
  }
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Transpose(worldToView, matrix);
  vtkMatrix4x4::Multiply4x4(matrix, volumeToWorld, matrix);
  vtkMatrix4x4::Multiply4x4(matrix, model, matrix);
  matrix->Transpose();
  const glm::dmat3 linear = glm::dmat3(glm::make_mat4(matrix->GetData()));
  glm::mat3 gradient = glm::mat3(glm::inverse(glm::transpose(linear)));
  this->IsMirrored = glm::determinant(linear) < 0.0;
  this->Triangles.Program->SetUniformMatrix("in_modelToView", matrix);
  this->Triangles.Program->SetUniformMatrix3x3("in_gradientToView", &gradient[0][0]);
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::BindTextures(vtkShaderProgram* program)
{
  const auto bind = [program](const char* name, vtkTextureObject* texture) {
    texture->Activate();
    program->SetUniformi(name, texture->GetTextureUnit());
  };
  bind("in_table", this->Table);
  bind("in_isosurfaces", this->Isosurfaces);
  bind("in_opaqueDepth", this->Target.GetOpaqueDepth());
  program->SetUniformf("in_tableSize", static_cast<float>(this->Table->GetWidth()));
  program->SetUniformi(
    "in_numberOfIsosurfaces", static_cast<int>(this->Classification->GetIsosurfaces().size()));
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::UnbindTextures()
{
  this->Table->Deactivate();
  this->Isosurfaces->Deactivate();
  this->Target.GetOpaqueDepth()->Deactivate();
}

//------------------------------------------------------------------------------
void ProjectedTetrahedraPainter::Release(vtkWindow* window)
{
  this->Triangles.ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
  this->Table->ReleaseGraphicsResources(window);
  this->Isosurfaces->ReleaseGraphicsResources(window);
  this->Target.Release(window);
  this->AreVerticesUploaded = false;
  this->IsClassificationUploaded = false;
}
