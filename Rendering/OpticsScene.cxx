// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpticsScene.h"

#include "DefaultOptics.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

namespace
{
// Opacity depends on the first component, or on the last one where the components belong together.
int OpacityComponent(vtkDataArray* scalars, vtkVolumeProperty* property)
{
  const int components = scalars->GetNumberOfComponents();
  return components == 1 || property->GetIndependentComponents() ? 0 : components - 1;
}

vtkOpticsVolumeProperty* FindOptics(vtkOpticsVolumeMapper* mapper, vtkVolume* volume)
{
  if (auto* own = vtkOpticsVolumeProperty::SafeDownCast(volume->GetProperty()))
  {
    return own;
  }
  return mapper->GetOptics() ? mapper->GetOptics() : DefaultOptics::Get();
}
}

//------------------------------------------------------------------------------
OpticsScene MakeOpticsScene(vtkOpticsVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  OpticsScene scene = {};
  scene.Mapper = mapper;
  scene.Renderer = renderer;
  scene.Volume = volume;
  scene.Optics = FindOptics(mapper, volume);
  scene.Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  int cellFlag = 0;
  scene.Scalars = vtkAbstractMapper::GetScalars(mapper->GetDataSetInput(), mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  scene.CellScalars = cellFlag == 1;
  scene.OpacityComponent = scene.Scalars ? OpacityComponent(scene.Scalars, volume->GetProperty()) : 0;
  return scene;
}
