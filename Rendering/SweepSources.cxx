// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SweepSources.h"

#include "RayUniforms.h"
#include "SceneNeeds.h"
#include "TransferFunctionTerm.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <cstring>
#include <functional>
#include <string>

namespace
{
using Sources = std::vector<std::pair<const void*, vtkMTimeType>>;

void AddObject(Sources& sources, vtkObject* object)
{
  sources.emplace_back(object, object ? object->GetMTime() : 0);
}

// By its bits.
void AddNumber(Sources& sources, double number)
{
  vtkMTimeType bits = 0;
  static_assert(sizeof(bits) == sizeof(number), "a time is as long as a number");
  std::memcpy(&bits, &number, sizeof(bits));
  sources.emplace_back(nullptr, bits);
}

// In which VTK's coordinates lie: a turned box may have its corners where they were.
void AddPlace(Sources& sources, const OpticsScene& scene)
{
  for (int i = 0; i < 16; ++i)
  {
    AddNumber(sources, scene.Volume->GetMatrix()->GetData()[i]);
  }
}

void AddLabels(Sources& sources, vtkVolumeProperty* property)
{
  for (const int label : property->GetLabelMapLabels())
  {
    AddNumber(sources, label);
    AddObject(sources, property->GetLabelScalarOpacity(label));
  }
}

void AddIsosurfaces(Sources& sources, vtkOpticsVolumeProperty* optics)
{
  for (int i = 0; i < optics->GetNumberOfIsosurfaces(); ++i)
  {
    AddNumber(sources, optics->GetIsosurfaceValue(i));
    AddNumber(sources, optics->GetIsosurfaceOpacity(i));
  }
}

// The tables of opacity, whose entries belong to a step of the ray; colour and light are the eye's alone.
void AddOpacity(Sources& sources, const OpticsScene& scene)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  AddObject(sources, property->GetScalarOpacity(scene.OpacityComponent));
  AddObject(
    sources, HasGradientOpacity(scene) ? property->GetGradientOpacity(scene.OpacityComponent) : nullptr);
  AddObject(sources, Is2D(scene) ? property->GetTransferFunction2D() : nullptr);
  AddLabels(sources, property);
  AddNumber(sources, property->GetInterpolationType());
  AddNumber(sources, UnitDistance(scene));
  AddNumber(sources, UnitsPerRange(scene));
  AddNumber(sources, scene.Mapper->GetFrameSampleDistance(scene.Volume));
  double range[2];
  TransferFunctionTerm::GetOpacityRange(scene, range);
  AddNumber(sources, range[0]);
  AddNumber(sources, range[1]);
  AddIsosurfaces(sources, scene.Optics);
}

// Rules, and the normals along which they look, which may be given to the mapper.
void AddClassification(Sources& sources, const OpticsScene& scene)
{
  if (ReplacesClassification(scene))
  {
    AddObject(sources, scene.Mapper);
    AddObject(sources, scene.Optics);
  }
}

// Opacity and light of lines are the mapper's own, and for one view.
void AddLines(Sources& sources, const OpticsScene& scene)
{
  AddObject(sources, scene.Optics);
  AddObject(sources, scene.Mapper);
  AddObject(sources, scene.Mapper->GetLineOpacityFunction());
  AddObject(sources, scene.Mapper->GetLineBlock());
  AddObject(sources, scene.Renderer->GetActiveCamera());
}
}

//------------------------------------------------------------------------------
std::vector<std::pair<const void*, vtkMTimeType>> SweepSources(
  const OpticsScene& scene, vtkShaderProgram* ray)
{
  Sources sources;
  sources.emplace_back(nullptr, std::hash<std::string>()(ray->GetMD5Hash()));
  AddObject(sources, scene.Mapper->GetDataSetInput());
  AddObject(sources, scene.Scalars);
  AddObject(sources, scene.Mapper->GetMaskInput());
  AddPlace(sources, scene);
  if (HasLineVoxels(scene))
  {
    AddLines(sources, scene);
  }
  else
  {
    AddOpacity(sources, scene);
    AddClassification(sources, scene);
  }
  return sources;
}
