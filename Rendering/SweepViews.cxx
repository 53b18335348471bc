// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SweepViews.h"

#include "SceneNeeds.h"
#include "SweepSources.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"
#include "vtkVolume.h"

#include <algorithm>
#include <vector>

namespace
{
using F = OpticsFeature;

// OpenGL looks along -z.
void SetWorldToView(vtkMatrix4x4* worldToEye, double worldToView[16])
{
  std::copy(worldToEye->GetData(), worldToEye->GetData() + 16, worldToView);
  for (int i = 8; i < 12; ++i)
  {
    worldToView[i] = -worldToView[i];
  }
}

void TextureCorners(const double textureToWorld[16], const double box[6], double corners[24])
{
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { box[corner & 1], box[2 + ((corner >> 1) & 1)], box[4 + ((corner >> 2) & 1)], 1.0 };
    vtkMatrix4x4::MultiplyPoint(textureToWorld, point, point);
    std::copy(point, point + 3, corners + 3 * corner);
  }
}
}

//------------------------------------------------------------------------------
void AddSweepFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  for (const F feature :
    { F::VisibilitySweep, F::OpacityFormulas, F::DataSpaceFormulas, F::VisibilityFormulas })
  {
    features.Add(feature);
  }
  features.Add(scene.Mapper->GetClippingPlanes() ? F::SweepClipping : F::SweepClippingNone);
  if (NeedsFrames(scene))
  {
    features.Add(F::SweepFrame);
  }
  if (ReplacesIntegral(scene))
  {
    features.Add(F::SweepOfSegment);
    features.Add(IntegratesInData(scene) ? F::SweepInData : F::SweepInSpace);
    features.Add(HasIsosurfaces(scene) ? F::SweepIsosurfaces : F::SweepIsosurfacesNone);
  }
  else
  {
    features.Add(F::SweepOfSample);
  }
}

//------------------------------------------------------------------------------
std::string FindUnsweepable(const OpticsScene& scene)
{
  const int ofBlocks = scene.Mapper->GetNumberOfBlocks() > 1 ? 1 : 0;
  const int needed = (scene.Mapper->GetVisibilitySamples() + 3) / 4 + ofBlocks;
  vtkTextureUnitManager* units = scene.Window->GetState()->GetTextureUnitManager();
  int free = 0;
  for (int unit = 0; unit < units->GetNumberOfTextureUnits(); ++unit)
  {
    free += units->IsAllocated(unit) ? 0 : 1;
  }
  return free >= needed ? std::string()
                        : "it needs " + std::to_string(needed) + " texture units, of which " +
      std::to_string(free) + " are left; lower SetVisibilitySamples().";
}

//------------------------------------------------------------------------------
bool IsSelection(const OpticsScene& scene)
{
  return scene.Renderer->GetSelector() != nullptr;
}

//------------------------------------------------------------------------------
SweepGrid::View CameraView(const OpticsScene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(scene.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  SweepGrid::View view;
  SetWorldToView(camera->GetModelViewTransformMatrix(), view.WorldToView);
  view.IsPerspective = projection->GetElement(3, 2) != 0.0;
  camera->GetClippingRange(view.Range);
  for (int axis = 0; axis < 2; ++axis)
  {
    // of device coordinates, which are -1 and 1 at the window's sides
    const double scale = projection->GetElement(axis, axis);
    const double shift =
      view.IsPerspective ? -projection->GetElement(axis, 2) : projection->GetElement(axis, 3);
    const double ends[2] = { (-1.0 - shift) / scale, (1.0 - shift) / scale };
    view.Window[2 * axis] = std::min(ends[0], ends[1]);
    view.Window[2 * axis + 1] = std::max(ends[0], ends[1]);
  }
  return view;
}

//------------------------------------------------------------------------------
void VolumeCorners(const OpticsScene& scene, double corners[24])
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const int* extent = image->GetExtent();
  for (int corner = 0; corner < 8; ++corner)
  {
    double index[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = extent[2 * axis + ((corner >> axis) & 1)];
    }
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    image->TransformContinuousIndexToPhysicalPoint(index, point);
    scene.Volume->GetMatrix()->MultiplyPoint(point, point);
    std::copy(point, point + 3, corners + 3 * corner);
  }
}

//------------------------------------------------------------------------------
SweepGrid::Resolution SweepResolution(const OpticsScene& scene)
{
  // presets are coarser while the user interacts, as their steps are
  const int coarseness = scene.Mapper->GetCoarseness();
  const int size = scene.Mapper->GetVisibilityGridSize();
  // four directions to a texel, one group behind the other
  const int layers = GathersOcclusion(scene) ? (scene.Mapper->GetVisibilitySamples() + 3) / 4 : 1;
  return { (size + coarseness - 1) / coarseness, scene.Mapper->GetVisibilitySliceDistance(),
    vtkTextureObject::GetMaximumTextureSize3D(scene.Window) / layers };
}

//------------------------------------------------------------------------------
void SetSweepKnobs(const OpticsScene& scene, vtkVisibilitySweep* sweep)
{
  sweep->SetAlgorithm(scene.Mapper->GetVisibilityAlgorithm());
  sweep->SetNumberOfDirections(scene.Mapper->GetVisibilitySamples());
  sweep->SetDiskSize(scene.Mapper->GetVisibilityDiskSize());
  sweep->SetTrueDistances(scene.Mapper->GetVisibilityTrueDistances());
  sweep->SetPrecision(scene.Mapper->GetVisibilityPrecision());
}

//------------------------------------------------------------------------------
vtkVisibilitySweep::Volume SweptVolume(const OpticsScene& scene, vtkShaderProgram* ray)
{
  vtkVisibilitySweep::Volume volume = {};
  volume.Window = scene.Window;
  volume.Ray = ray;
  volume.IsInBlocks = scene.Mapper->GetNumberOfBlocks() > 1;
  volume.FillsBlock = volume.IsInBlocks && scene.FillsBlocks;
  volume.Block = scene.Block;
  vtkMatrix4x4* dataToWorld = scene.Volume->GetMatrix();
  double textureToData[16];
  scene.Mapper->GetTextureToData(textureToData);
  vtkMatrix4x4::Multiply4x4(dataToWorld->GetData(), textureToData, volume.TextureToWorld);
  std::copy(dataToWorld->GetData(), dataToWorld->GetData() + 16, volume.DataToWorld);
  volume.StepLength = scene.Mapper->GetFrameSampleDistance(scene.Volume);
  volume.Times = SweepSources(scene, ray);
  volume.SkipsEmptySpace = scene.Mapper->GetSkipEmptySpace();
  VolumeCorners(scene, volume.Box);
  double box[6];
  if (!ReplacesIntegral(scene) && !HasLineVoxels(scene) && scene.Mapper->FindVisibleBox(box))
  {
    TextureCorners(volume.TextureToWorld, box, volume.Box);
  }
  return volume;
}

//------------------------------------------------------------------------------
void SetGridUniform(const SweepGrid& grid, const vtkVisibilitySweep::Volume& volume, const char* name,
  vtkShaderProgram* program, bool isInMiddle)
{
  double matrix[16];
  grid.GetWorldToTexture(matrix, isInMiddle);
  vtkMatrix4x4::Multiply4x4(matrix, volume.TextureToWorld, matrix);
  float columns[16];
  for (int i = 0; i < 16; ++i)
  {
    columns[4 * (i % 4) + i / 4] = static_cast<float>(matrix[i]);
  }
  program->SetUniformMatrix4x4(name, columns);
}
