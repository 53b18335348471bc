// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TermTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
bool TermTexture::IsAlive(vtkOpenGLRenderWindow* window) const
{
  return this->Texture && this->Texture->GetContext() == window && this->Texture->GetHandle() != 0;
}

//------------------------------------------------------------------------------
vtkTextureObject* TermTexture::Renew(vtkOpenGLRenderWindow* window)
{
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  return this->Texture;
}

//------------------------------------------------------------------------------
void TermTexture::Interpolate()
{
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
}

//------------------------------------------------------------------------------
void TermTexture::Bind(const char* sampler, vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi(sampler, this->Texture->GetTextureUnit());
}

//------------------------------------------------------------------------------
void TermTexture::Unbind()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void TermTexture::Release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}
