// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineVolume.h"

#include "vtkOpticsVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <limits>

using volumeoptics::LineGrid;

namespace
{
// VTK's matrices are rows.
glm::dmat4 FromVTK(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

glm::dmat4 MakeDataToVoxels(vtkImageData* image, const LineGrid& grid)
{
  const int* extent = image->GetExtent();
  const glm::dvec3 first(extent[0], extent[2], extent[4]);
  return glm::scale(glm::dmat4(1.0), glm::dvec3(grid.Brick)) * glm::translate(glm::dmat4(1.0), -first) *
    FromVTK(image->GetPhysicalToIndexMatrix());
}
}

//------------------------------------------------------------------------------
std::string LineVolume::Update(vtkImageData* image, const OpticsScene& scene)
{
  std::string error = this->Upload(image, scene.Mapper->GetLinePrecision(), scene.Window);
  if (!error.empty() || this->IsEmpty())
  {
    return error;
  }
  std::vector<volumeoptics::LineScale> scales;
  for (const LineTextures::Type& type : this->Lines.Types)
  {
    scales.push_back(
      { scene.Mapper->GetLineRadiusScale(type.Number), scene.Mapper->GetLineOpacityScale(type.Number) });
  }
  this->Evaluation.Update(this->Lines, this->ViewOf(scene), scales, scene.Mapper->GetLineOpacityFunction(),
    this->UploadedBits, scene.Window);
  return error;
}

//------------------------------------------------------------------------------
std::string LineVolume::Upload(vtkImageData* image, int bits, vtkOpenGLRenderWindow* window)
{
  const bool isCurrent = image == this->Uploaded && image->GetMTime() == this->UploadedTime &&
    bits == this->UploadedBits && (this->IsEmpty() || this->Lines.IsAlive(window));
  if (isCurrent)
  {
    return "";
  }
  this->Uploaded = nullptr;
  this->Evaluation.Invalidate();
  std::string error = this->Lines.Upload(image, bits, window);
  if (error.empty())
  {
    this->DataToVoxels = MakeDataToVoxels(image, this->Lines.Grid);
    this->Uploaded = image;
    this->UploadedTime = image->GetMTime();
    this->UploadedBits = bits;
  }
  return error;
}

//------------------------------------------------------------------------------
LineView LineVolume::ViewOf(const OpticsScene& scene) const
{
  const glm::dmat4 worldToLengths = glm::scale(glm::dmat4(1.0), this->Lines.Grid.Voxel) * this->DataToVoxels *
    glm::inverse(FromVTK(scene.Volume->GetMatrix()));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  glm::dvec4 position(0.0, 0.0, 0.0, 1.0), direction(0.0);
  camera->GetPosition(&position.x);
  camera->GetDirectionOfProjection(&direction.x);
  LineView view;
  view.Position = glm::dvec3(worldToLengths * position);
  view.ToEye = -glm::normalize(glm::dvec3(worldToLengths * direction));
  view.IsParallel = camera->GetParallelProjection() != 0;
  return view;
}

//------------------------------------------------------------------------------
glm::vec3 LineVolume::GetLeastColor() const
{
  glm::vec3 least(std::numeric_limits<float>::max());
  for (const LineTextures::Type& type : this->Lines.Types)
  {
    least = glm::min(least, type.LeastColor);
  }
  return least;
}

//------------------------------------------------------------------------------
void LineVolume::SetUniforms(const std::string& name, vtkShaderProgram* program)
{
  const LineGrid& grid = this->Lines.Grid;
  const glm::vec3 dimensions(grid.Dimensions);
  program->SetUniform3f((name + "Dimensions").c_str(), &dimensions.x);
  program->SetUniformf(
    (name + "UnitInverse").c_str(), static_cast<float>(grid.Surface() / (4.0 * grid.Volume())));
  this->Lines.Bricks.Bind((name + "Bricks").c_str(), program);
  this->Lines.Cells.Bind((name + "Cells").c_str(), program);
  this->Evaluation.Atlas.Bind((name + "Atlas").c_str(), program);
}

//------------------------------------------------------------------------------
void LineVolume::UnbindTextures()
{
  this->Lines.Bricks.Unbind();
  this->Lines.Cells.Unbind();
  this->Evaluation.Atlas.Unbind();
}

//------------------------------------------------------------------------------
void LineVolume::Release(vtkWindow* window)
{
  this->Lines.Release(window);
  this->Evaluation.Release(window);
  this->Uploaded = nullptr;
}

//------------------------------------------------------------------------------
std::size_t LineVolume::GetMemorySize() const
{
  return this->Lines.GetMemorySize() + this->Evaluation.GetMemorySize();
}
