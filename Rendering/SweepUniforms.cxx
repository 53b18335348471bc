// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the shader of a sweep is told of its grid and cone.

#include "vtkVisibilitySweep.h"

#include "Optics.h"
#include "SweepGrid.h"
#include "SweepProgram.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <cmath>

namespace
{
// OpenGL reads columns.
void SetMatrix(vtkShaderProgram* program, const char* name, const double matrix[16])
{
  float columns[16];
  for (int i = 0; i < 16; ++i)
  {
    columns[4 * (i % 4) + i / 4] = static_cast<float>(matrix[i]);
  }
  program->SetUniformMatrix4x4(name, columns);
}

void SetVector(vtkShaderProgram* program, const char* name, double x, double y, double z, double w)
{
  const float vector[4] = { static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
    static_cast<float>(w) };
  program->SetUniform4f(name, vector);
}
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetUniforms(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program)
{
  double worldToTexture[16];
  double viewToTexture[16];
  double dataToTexture[16];
  vtkMatrix4x4::Invert(volume.TextureToWorld, worldToTexture);
  vtkMatrix4x4::Invert(grid.GetWorldToView(), viewToTexture);
  vtkMatrix4x4::Multiply4x4(worldToTexture, viewToTexture, viewToTexture);
  vtkMatrix4x4::Multiply4x4(worldToTexture, volume.DataToWorld, dataToTexture);
  double viewToWorld[16];
  vtkMatrix4x4::Invert(grid.GetWorldToView(), viewToWorld);
  SetMatrix(program, "in_sweepToTexture", viewToTexture);
  SetMatrix(program, "in_sweepToWorld", viewToWorld);
  SetMatrix(program, "in_sweepDataToTexture", dataToTexture);

  const double* window = grid.GetWindow();
  const double sides[2] = { window[1] - window[0], window[3] - window[2] };
  SetVector(program, "in_sweepWindow", window[0], window[2], sides[0], sides[1]);
  SetVector(program, "in_sweepWindowCode", 1.0 / sides[0], 1.0 / sides[1], -window[0] / sides[0],
    -window[2] / sides[1]);
  const float froxel[2] = { 1.0F / static_cast<float>(grid.GetSize()[0]),
    1.0F / static_cast<float>(grid.GetSize()[1]) };
  program->SetUniform2f("in_sweepFroxel", froxel);
  program->SetUniformf("in_sweepSliceDistance", static_cast<float>(grid.GetSliceDistance()));
  this->SetConeUniforms(volume, grid, program);
}

//------------------------------------------------------------------------------
// Ways are measured in the data's coordinates, as VTK measures the steps of the ray: the volume's matrix may
// scale unevenly.
void vtkVisibilitySweep::SetConeUniforms(
  const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program)
{
  double worldToData[16];
  double viewToData[16];
  vtkMatrix4x4::Invert(volume.DataToWorld, worldToData);
  vtkMatrix4x4::Invert(grid.GetWorldToView(), viewToData);
  vtkMatrix4x4::Multiply4x4(worldToData, viewToData, viewToData);
  const double axis = std::sqrt(
    viewToData[2] * viewToData[2] + viewToData[6] * viewToData[6] + viewToData[10] * viewToData[10]);
  const double steps = axis * grid.GetSliceDistance() / volume.StepLength;
  program->SetUniformf("in_sweepStepsOfSlice", static_cast<float>(steps));
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(viewToData[4 * (i % 3) + i / 3] / axis);
  }
  program->SetUniformMatrix3x3("in_sweepToSlices", columns);
  program->SetUniformf("in_sweepViewerDistance", static_cast<float>(this->ViewerDistance));
  this->Algorithm == DirectionSweep ? this->SetDirections(viewToData, axis, program) : this->SetDisk(program);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetDirections(const double viewToData[16], double axis, vtkShaderProgram* program)
{
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(this->ConeAngle));
  float slopes[SweepProgram::LargestNumberOfDirections][2] = {};
  float lengths[SweepProgram::LargestNumberOfDirections] = {};
  for (int i = 0; i < this->NumberOfDirections; ++i)
  {
    const optics::ConeRay ray = optics::ConeDirection(i, this->NumberOfDirections, cosine);
    double way[4] = { ray.slope.x, ray.slope.y, -1.0, 0.0 };
    vtkMatrix4x4::MultiplyPoint(viewToData, way, way);
    slopes[i][0] = static_cast<float>(ray.slope.x);
    slopes[i][1] = static_cast<float>(ray.slope.y);
    lengths[i] = static_cast<float>(vtkMath::Norm(way) / axis);
  }
  program->SetUniform2fv("in_sweepSlopes", SweepProgram::LargestNumberOfDirections, slopes);
  program->SetUniform1fv("in_sweepLengths", SweepProgram::LargestNumberOfDirections, lengths);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetGeometry(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program)
{
  if (volume.Geometry)
  {
    volume.Geometry->Activate();
    program->SetUniformi("in_sweepGeometry", volume.Geometry->GetTextureUnit());
    const double range[3] = { volume.GeometryRange[0], volume.GeometryRange[1],
      grid.GetIsPerspective() ? 1.0 : 0.0 };
    program->SetUniform3f("in_sweepGeometryRange", range);
  }
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetDisk(vtkShaderProgram* program)
{
  program->SetUniformi("in_sweepDiskSize", this->DiskSize);
  program->SetUniformf("in_sweepTrueDistances", this->TrueDistances ? 1.0F : 0.0F);
  program->SetUniformf("in_sweepSolidAngles", this->Algorithm == DiskSolidAngle ? 1.0F : 0.0F);
  program->SetUniformf(
    "in_sweepConeTangent", static_cast<float>(std::tan(vtkMath::RadiansFromDegrees(this->ConeAngle))));
}
