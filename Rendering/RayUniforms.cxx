// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RayUniforms.h"

#include "LineVoxels.h"
#include "TransferFunctionTerm.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace
{
// OpenGL reads columns, VTK's matrices are rows.
void SetMatrix(vtkShaderProgram* program, const char* name, vtkMatrix3x3* matrix)
{
  vtkNew<vtkMatrix3x3> columns;
  vtkMatrix3x3::Transpose(matrix, columns);
  program->SetUniformMatrix(name, columns);
}
}

//------------------------------------------------------------------------------
double SmallestSpacing(const OpticsScene& scene)
{
  double spacing[3];
  volumeoptics::GetVoxelSpacing(vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput()), spacing);
  return std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
}

//------------------------------------------------------------------------------
double UnitDistance(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetScalarOpacityUnitDistance(scene.OpacityComponent);
}

//------------------------------------------------------------------------------
void WidenEmptyRange(double range[2])
{
  if (!(range[1] > range[0]))
  {
    range[1] = range[0] + std::max(1.0, std::abs(range[0])) * 1.0e-3;
  }
}

//------------------------------------------------------------------------------
void ScalarRange(const OpticsScene& scene, int component, double range[2])
{
  scene.Mapper->GetLoadedScalarRange(component, range);
  WidenEmptyRange(range);
}

//------------------------------------------------------------------------------
void CoordinateRange(const OpticsScene& scene, double range[2])
{
  ScalarRange(scene, scene.OpacityComponent, range);
  const int type = scene.Scalars->GetDataType();
  const bool isCode = scene.Scalars->GetDataTypeSize() <= 2 && type != VTK_BIT;
  const double largest = isCode ? scene.Scalars->GetDataTypeMax() : 0.0;
  const double factor = isCode ? largest / (largest + 1.0) : 1.0;
  range[0] *= factor;
  range[1] *= factor;
}

//------------------------------------------------------------------------------
// The volume's own functions count also where the optics are those of the mapper. Bounded to what a float
// holds.
double UnitsPerRange(const OpticsScene& scene)
{
  const double* nodes = scene.Volume->GetProperty()->GetScalarOpacity()->GetRange();
  const double set = scene.Optics->GetScalarOpacityUnitInterval();
  const double unit = set > 0.0 ? set : (nodes[1] - nodes[0]) / 100.0;
  double range[2];
  TransferFunctionTerm::GetOpacityRange(scene, range);
  return unit > 0.0 ? std::clamp((range[1] - range[0]) / unit, 1.0e-30, 1.0e30) : 100.0;
}

//------------------------------------------------------------------------------
void SetSpaceUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  vtkNew<vtkMatrix4x4> dataToEye;
  vtkMatrix4x4::Multiply4x4(
    scene.Renderer->GetActiveCamera()->GetModelViewTransformMatrix(), scene.Volume->GetMatrix(), dataToEye);
  vtkNew<vtkMatrix3x3> tangents;
  for (int i = 0; i < 9; ++i)
  {
    tangents->SetElement(i / 3, i % 3, dataToEye->GetElement(i / 3, i % 3));
  }
  SetMatrix(program, "in_opticsTangentToEye", tangents);
  vtkNew<vtkMatrix3x3> normals;
  vtkMatrix3x3::Invert(tangents, normals);
  program->SetUniformMatrix("in_opticsNormalToEye", normals); // transposed by not transposing
}

//------------------------------------------------------------------------------
void SetScalarUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  float channel[4] = {};
  channel[scene.OpacityComponent] = 1.0F;
  program->SetUniform4f("in_opticsOpacityChannel", channel);
}

//------------------------------------------------------------------------------
void SetDifferences(const OpticsScene& scene, double length, const char* name, vtkShaderProgram* program)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  vtkNew<vtkMatrix3x3> matrix;
  for (int i = 0; i < 9; ++i)
  {
    const double step = 2.0 * image->GetSpacing()[i % 3];
    matrix->SetElement(i / 3, i % 3, image->GetDirectionMatrix()->GetElement(i / 3, i % 3) * length / step);
  }
  SetMatrix(program, name, matrix);
}
