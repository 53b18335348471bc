// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineVoxelTerm.h"

#include "SceneNeeds.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

namespace
{
void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  vtkNew<vtkMatrix4x4> columns; // as OpenGL reads them
  columns->DeepCopy(glm::value_ptr(matrix));
  program->SetUniformMatrix(name, columns);
}

void CheckLights(const OpticsScene& scene, vtkImageData* image)
{
  if (!volumeoptics::HasLights(image, volumeoptics::ReadLights(scene.Renderer->GetLights())))
  {
    scene.Mapper->Say("The renderer's lights are not those that the lines' voxels were made with, which are "
                      "drawn. Give these lights to vtkAnisotropicLineVoxelizer by SetLights().");
  }
}
}

//------------------------------------------------------------------------------
vtkImageData* LineVoxelTerm::GetBlock() const
{
  if (!this->BlockInput.Producer)
  {
    return nullptr;
  }
  this->BlockInput.Producer->Update(this->BlockInput.Port);
  return vtkImageData::SafeDownCast(this->BlockInput.Producer->GetOutputDataObject(this->BlockInput.Port));
}

//------------------------------------------------------------------------------
bool LineVoxelTerm::IsActive(const OpticsScene& scene)
{
  if (!HasLineVoxels(scene))
  {
    return false;
  }
  const std::string reason = FindUnsupportedByLines(scene);
  if (!reason.empty())
  {
    scene.Mapper->Say("Lines as anisotropic voxels do not support " + reason + ": they are not drawn.");
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool LineVoxelTerm::Prepare(const OpticsScene& scene)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const std::string error = this->Lines.Update(image, scene);
  if (!error.empty())
  {
    scene.Mapper->Say(error);
  }
  if (!error.empty() || this->Lines.IsEmpty())
  {
    return false;
  }
  CheckLights(scene, image);
  this->PrepareBlock(scene);
  return true;
}

//------------------------------------------------------------------------------
void LineVoxelTerm::PrepareBlock(const OpticsScene& scene)
{
  vtkImageData* image = this->GetBlock();
  std::string error = image ? this->Block.Update(image, scene) : "";
  if (image && error.empty() && this->Block.IsEmpty())
  {
    error = "It holds no lines: give it the voxels of some by vtkAnisotropicLineVoxelizer.";
  }
  if (!error.empty())
  {
    scene.Mapper->Say("The block of lines is left out. " + error);
  }
  this->HasBlock = image && error.empty();
  if (this->HasBlock)
  {
    CheckLights(scene, image);
  }
  else
  {
    this->Block.Release(scene.Renderer->GetVTKWindow());
  }
}

//------------------------------------------------------------------------------
void LineVoxelTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(OpticsFeature::Lines);
  features.Add(OpticsFeature::RayEnd);
  features.Add(this->HasBlock ? OpticsFeature::LineBlock : OpticsFeature::LineBlockNone);
  features.Add(HasAmbientLight(scene) ? OpticsFeature::LineAmbient : OpticsFeature::LineAmbientNone);
  features.Add(OpticsFeature::OpacityFormulas);
}

//------------------------------------------------------------------------------
void LineVoxelTerm::SetUniforms(const OpticsScene&, vtkShaderProgram* program)
{
  const glm::dmat4 toLines = this->Lines.GetDataToVoxels();
  SetMatrix(program, "in_opticsDataToLines", toLines);
  this->Lines.SetUniforms("in_opticsLine", program);
  glm::vec3 ambient = this->Lines.GetLeastColor();
  if (this->HasBlock)
  {
    SetMatrix(program, "in_opticsLinesToBlock", this->Block.GetDataToVoxels() * glm::inverse(toLines));
    this->Block.SetUniforms("in_opticsBlock", program);
    ambient = glm::min(ambient, this->Block.GetLeastColor());
  }
  program->SetUniform3f("in_opticsLineAmbient", &ambient.x);
}

//------------------------------------------------------------------------------
void LineVoxelTerm::UnbindTextures()
{
  this->Lines.UnbindTextures();
  this->Block.UnbindTextures();
}

//------------------------------------------------------------------------------
void LineVoxelTerm::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Lines.Release(window);
  this->Block.Release(window);
}

//------------------------------------------------------------------------------
std::size_t LineVoxelTerm::GetMemorySize() const
{
  return this->Lines.GetMemorySize() + this->Block.GetMemorySize();
}
