// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ScalarOpacityTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Enough for the nodes of the function; every OpenGL 3.2 has twice the largest.
int TableWidth(vtkPiecewiseFunction* opacity, const double range[2])
{
  return std::clamp(opacity->EstimateMinNumberOfSamples(range[0], range[1]), 1024, 8192);
}
}

//------------------------------------------------------------------------------
void ScalarOpacityTexture::Update(
  vtkPiecewiseFunction* opacity, const double range[2], vtkOpenGLRenderWindow* window)
{
  const bool isAlive =
    this->Texture && this->Texture->GetContext() == window && this->Texture->GetHandle() != 0;
  const bool isCurrent = isAlive && this->Source == opacity && this->SourceTime == opacity->GetMTime() &&
    this->Range[0] == range[0] && this->Range[1] == range[1];
  if (isCurrent)
  {
    return;
  }
  const int width = TableWidth(opacity, range);
  std::vector<float> table(width);
  opacity->GetTable(range[0], range[1], width, table.data());
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  this->Texture->Create1DFromRaw(width, 1, VTK_FLOAT, table.data());
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Source = opacity;
  this->SourceTime = opacity->GetMTime();
  std::copy(range, range + 2, this->Range);
}

//------------------------------------------------------------------------------
void ScalarOpacityTexture::SetUniforms(vtkShaderProgram* program)
{
  const float width = static_cast<float>(this->Texture->GetWidth());
  const float code[2] = { (width - 1.0F) / width, 0.5F / width };
  program->SetUniform2f("in_opticsOpacityTableCode", code);
  this->Texture->Activate();
  program->SetUniformi("in_opticsOpacityTable", this->Texture->GetTextureUnit());
}

//------------------------------------------------------------------------------
void ScalarOpacityTexture::Unbind()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void ScalarOpacityTexture::Release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}

//------------------------------------------------------------------------------
std::size_t ScalarOpacityTexture::GetMemorySize() const
{
  return this->Texture ? this->Texture->GetWidth() * sizeof(float) : 0;
}
