// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TransferFunctionTexture.h"

#include "vtkColorTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <vector>

namespace
{
// Enough for the nodes of the function; every OpenGL 3.2 has twice the largest.
int TableWidth(int wanted)
{
  return std::clamp(wanted, 1024, 8192);
}
}

//------------------------------------------------------------------------------
void TransferFunctionTexture::Update(
  vtkPiecewiseFunction* opacity, const double range[2], vtkOpenGLRenderWindow* window)
{
  this->UpdateTable(
    opacity, range, TableWidth(opacity->EstimateMinNumberOfSamples(range[0], range[1])), 1, window);
}

//------------------------------------------------------------------------------
void TransferFunctionTexture::Update(
  vtkColorTransferFunction* color, const double range[2], vtkOpenGLRenderWindow* window)
{
  this->UpdateTable(
    color, range, TableWidth(color->EstimateMinNumberOfSamples(range[0], range[1])), 3, window);
}

//------------------------------------------------------------------------------
template <typename Function>
void TransferFunctionTexture::UpdateTable(
  Function* function, const double range[2], int width, int components, vtkOpenGLRenderWindow* window)
{
  const bool isCurrent = this->Texture.IsAlive(window) && this->Source == function &&
    this->SourceTime == function->GetMTime() && this->Range[0] == range[0] && this->Range[1] == range[1];
  if (isCurrent)
  {
    return;
  }
  std::vector<float> table(static_cast<std::size_t>(width) * components);
  function->GetTable(range[0], range[1], width, table.data());
  this->Texture.Renew(window);
  this->Texture->Create1DFromRaw(width, components, VTK_FLOAT, table.data());
  this->Texture.Interpolate();
  this->Source = function;
  this->SourceTime = function->GetMTime();
  std::copy(range, range + 2, this->Range);
}

//------------------------------------------------------------------------------
void TransferFunctionTexture::SetUniforms(const std::string& name, vtkShaderProgram* program)
{
  const float width = static_cast<float>(this->Texture->GetWidth());
  const float code[2] = { (width - 1.0F) / width, 0.5F / width };
  program->SetUniform2f((name + "Code").c_str(), code);
  this->Texture.Bind(name.c_str(), program);
}

//------------------------------------------------------------------------------
std::size_t TransferFunctionTexture::GetMemorySize() const
{
  return this->Texture ? sizeof(float) * this->Texture->GetWidth() * this->Texture->GetComponents() : 0;
}
