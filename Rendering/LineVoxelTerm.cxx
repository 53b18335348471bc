// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineVoxelTerm.h"

#include "SceneNeeds.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <glm/gtc/type_ptr.hpp>

using volumeoptics::LineGrid;

namespace
{
using Matrix = glm::dmat4;

// VTK's matrices are rows.
Matrix FromVTK(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

// Data space to voxels, from the corner of the first one.
Matrix DataToVoxels(vtkImageData* image, const LineGrid& grid)
{
  Matrix toVoxels(1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    toVoxels[axis][axis] = grid.Brick[axis];
    toVoxels[3][axis] = -static_cast<double>(image->GetExtent()[2 * axis]) * grid.Brick[axis];
  }
  return toVoxels * FromVTK(image->GetPhysicalToIndexMatrix());
}

LineView ViewOf(const OpticsScene& scene, vtkImageData* image, const LineGrid& grid)
{
  Matrix toLengths(1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    toLengths[axis][axis] = grid.Voxel[axis];
  }
  const Matrix worldToVoxels =
    toLengths * DataToVoxels(image, grid) * glm::inverse(FromVTK(scene.Volume->GetMatrix()));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  glm::dvec4 position(0.0, 0.0, 0.0, 1.0), direction(0.0);
  camera->GetPosition(&position.x);
  camera->GetDirectionOfProjection(&direction.x);
  LineView view;
  view.Position = glm::dvec3(worldToVoxels * position);
  view.ToEye = -glm::normalize(glm::dvec3(worldToVoxels * direction));
  view.IsParallel = camera->GetParallelProjection() != 0;
  return view;
}
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
  if (!this->Upload(scene, image) || this->Lines.Atlas.Tiles.empty())
  {
    return false;
  }
  this->CheckLights(scene, image);
  std::vector<volumeoptics::LineScale> scales;
  for (const LineTextures::Type& type : this->Lines.Types)
  {
    scales.push_back(
      { scene.Mapper->GetLineRadiusScale(type.Number), scene.Mapper->GetLineOpacityScale(type.Number) });
  }
  this->Evaluation.Update(this->Lines, ViewOf(scene, image, this->Lines.Grid), scales,
    scene.Mapper->GetLineOpacityFunction(), this->UploadedBits, scene.Window);
  return true;
}

//------------------------------------------------------------------------------
bool LineVoxelTerm::Upload(const OpticsScene& scene, vtkImageData* image)
{
  const int bits = scene.Mapper->GetLinePrecision();
  const bool isCurrent = image == this->Uploaded && image->GetMTime() == this->UploadedTime &&
    bits == this->UploadedBits && (this->Lines.Atlas.Tiles.empty() || this->Lines.IsAlive(scene.Window));
  if (isCurrent)
  {
    return true;
  }
  this->Uploaded = nullptr;
  this->Evaluation.Invalidate();
  const std::string error = this->Lines.Upload(image, bits, scene.Window);
  if (!error.empty())
  {
    scene.Mapper->Say(error);
    return false;
  }
  this->Uploaded = image;
  this->UploadedTime = image->GetMTime();
  this->UploadedBits = bits;
  return true;
}

//------------------------------------------------------------------------------
void LineVoxelTerm::CheckLights(const OpticsScene& scene, vtkImageData* image) const
{
  if (!volumeoptics::HasLights(image, volumeoptics::ReadLights(scene.Renderer->GetLights())))
  {
    scene.Mapper->Say("The renderer's lights are not those that the lines' voxels were made with, which are "
                      "drawn. Give these lights to vtkAnisotropicLineVoxelizer by SetLights().");
  }
}

//------------------------------------------------------------------------------
void LineVoxelTerm::AddFeatures(const OpticsScene&, OpticsFeatures& features)
{
  features.Add(OpticsFeature::Lines);
  features.Add(OpticsFeature::OpacityFormulas);
}

//------------------------------------------------------------------------------
void LineVoxelTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const LineGrid& grid = this->Lines.Grid;
  const glm::mat4 toVoxels(DataToVoxels(image, grid));
  vtkNew<vtkMatrix4x4> columns;
  for (int i = 0; i < 16; ++i)
  {
    columns->GetData()[i] = toVoxels[i / 4][i % 4];
  }
  program->SetUniformMatrix("in_opticsDataToLines", columns);
  const glm::vec3 dimensions(grid.Dimensions), brick(grid.Brick);
  program->SetUniform3f("in_opticsLineDimensions", &dimensions.x);
  program->SetUniform3f("in_opticsLineBrick", &brick.x);
  program->SetUniformf(
    "in_opticsLineUnitInverse", static_cast<float>(grid.Surface() / (4.0 * grid.Volume())));
  this->Lines.Bricks.Bind("in_opticsLineBricks", program);
  this->Evaluation.Atlas.Bind("in_opticsLineAtlas", program);
}

//------------------------------------------------------------------------------
void LineVoxelTerm::UnbindTextures()
{
  this->Lines.Bricks.Unbind();
  this->Evaluation.Atlas.Unbind();
}

//------------------------------------------------------------------------------
void LineVoxelTerm::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Lines.Release(window);
  this->Evaluation.Release(window);
  this->Uploaded = nullptr;
}

//------------------------------------------------------------------------------
std::size_t LineVoxelTerm::GetMemorySize() const
{
  return this->Lines.GetMemorySize() + this->Evaluation.GetMemorySize();
}
