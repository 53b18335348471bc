// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsShaderPass.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkShaderProgram.h"
#include "vtkVersion.h"
#include "vtkVolume.h"

vtkStandardNewMacro(vtkOpticsShaderPass);

namespace
{
void DrawNothing(std::string& fragment)
{
  vtkShaderProgram::Substitute(fragment, "void main()\n{", "void main()\n{\n  discard;", false);
}
}

//------------------------------------------------------------------------------
void vtkOpticsShaderPass::SetFeatures(const OpticsFeatures& features)
{
  if (!(features == this->Features))
  {
    this->Features = features;
    this->FeaturesTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOpticsShaderPass::Attach(const OpticsScene& scene, const std::vector<OpticsTerm*>& terms)
{
  this->Scene = scene;
  this->Terms = terms;
  if (!scene.Volume->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    scene.Volume->SetPropertyKeys(keys);
  }
  vtkInformation* keys = scene.Volume->GetPropertyKeys();
  // The mapper asks the last pass how many buffers it draws into; none would leave it without one.
  unsigned int buffers = 1;
  const int passes = keys->Length(vtkOpenGLRenderPass::RenderPasses());
  if (passes > 0)
  {
    auto* last =
      static_cast<vtkOpenGLRenderPass*>(keys->Get(vtkOpenGLRenderPass::RenderPasses(), passes - 1));
    buffers = last->GetActiveDrawBuffers();
  }
  this->SetActiveDrawBuffers(buffers);
  keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
}

//------------------------------------------------------------------------------
void vtkOpticsShaderPass::Detach()
{
  for (OpticsTerm* term : this->Terms)
  {
    term->UnbindTextures();
  }
  vtkInformation* keys = this->Scene.Volume->GetPropertyKeys();
  keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this);
  if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses());
  }
  this->Terms.clear();
  this->Scene = {};
  this->Program = nullptr;
}

//------------------------------------------------------------------------------
void vtkOpticsShaderPass::SayMissing(const std::string& text, const char* consequence)
{
  vtkErrorMacro(
    << "The volume shader of VTK " << vtkVersion::GetVTKVersion() << " has no \"" << text
    << "\", where the optical terms belong: " << consequence
    << " VTK 9.1 to 9.7 are known to have it; a replacement of the user's own may have removed it.");
}

//------------------------------------------------------------------------------
bool vtkOpticsShaderPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const std::string missing = InsertOpticsBeforeVTK(fragmentShader, this->Features);
  this->IsInserted = missing.empty();
  if (!this->IsInserted)
  {
    this->SayMissing(missing, "the volume is drawn without them.");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOpticsShaderPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const std::string missing =
    this->IsInserted ? ReplaceOpticsInVTK(fragmentShader, this->Features) : std::string();
  if (!missing.empty())
  {
    this->IsInserted = false;
    DrawNothing(fragmentShader);
    this->SayMissing(missing, "the volume is not drawn.");
  }
  this->FragmentShader = fragmentShader;
  return true;
}

//------------------------------------------------------------------------------
bool vtkOpticsShaderPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  this->Programs.insert(program->GetMD5Hash());
  this->Program = program;
  for (OpticsTerm* term : this->Terms)
  {
    term->SetUniforms(this->Scene, program);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkOpticsShaderPass::BeforeDraw()
{
  if (this->Program && this->IsInserted)
  {
    for (OpticsTerm* term : this->Terms)
    {
      term->BeforeDraw(this->Scene, this->Program);
    }
    ++this->Scene.Block;
  }
}
