// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OcclusionGathering.h"

#include "Optics.h"
#include "RayUniforms.h"
#include "SweepGrid.h"
#include "SweepProgram.h"
#include "SweepViews.h"
#include "VisibleInScene.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkDataArray.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// So far the interpolation between froxels reaches, and their mean from slice to slice; measured (docs/accuracy.md).
const double FroxelsOfRay = 3.5;

const double StepsInFront = 2.5;

// VTK keeps matrices row by row.
glm::dmat4 Columns(const double rows[16])
{
  return glm::transpose(glm::make_mat4(rows));
}

void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  glm::mat4 columns(matrix);
  program->SetUniformMatrix4x4(name, glm::value_ptr(columns));
}

void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat3& matrix)
{
  glm::mat3 columns(matrix);
  program->SetUniformMatrix3x3(name, glm::value_ptr(columns));
}

void SetWays(int directions, double angle, vtkShaderProgram* program)
{
  const double cosine = std::cos(glm::radians(angle));
  float ways[SweepProgram::LargestNumberOfDirections][3] = {};
  for (int i = 0; i < directions; ++i)
  {
    const optics::ConeRay ray = optics::ConeDirection(i, directions, cosine);
    ways[i][0] = static_cast<float>(ray.slope.x * ray.cosine);
    ways[i][1] = static_cast<float>(ray.slope.y * ray.cosine);
    ways[i][2] = static_cast<float>(-ray.cosine);
  }
  program->SetUniform3fv("in_opticsGatherWays", SweepProgram::LargestNumberOfDirections, ways);
}

// At the distance 1 in perspective.
double LengthOfRay(const SweepGrid& grid)
{
  const double froxel = (grid.GetWindow()[1] - grid.GetWindow()[0]) / grid.GetSize()[0];
  const double middle = grid.GetWidth(0.5 * (grid.GetDepth(0) + grid.GetDepth(grid.GetSize()[2] - 1)));
  return FroxelsOfRay * std::max(froxel, grid.GetSliceDistance() / middle);
}
}

//------------------------------------------------------------------------------
void AddGatheringFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(OpticsFeature::OcclusionGathered);
  features.NumberOfGatherSamples = scene.Mapper->GetVisibilityGatherSamples();
  features.Add(OpticsFeature::SampleScalar);
  // the user's own text may draw what has no opacity
  const bool isOurs = scene.Volume->GetShaderProperty()->GetNumberOfShaderReplacements() == 0;
  if (isOurs && scene.Scalars->GetNumberOfComponents() == 1 && IsSeenByScalars(scene))
  {
    features.Add(OpticsFeature::SeenSamples);
    features.Add(OpticsFeature::RayEnd);
  }
}

//------------------------------------------------------------------------------
// Along the ray from the eye it begins up to two steps and a half in front of the sample: half of its stretch, or all of
// the first, and what it is shifted.
void SetGatheringReach(const SweepGrid& grid, vtkVisibilitySweep::Volume& volume)
{
  const double length = LengthOfRay(grid);
  const double* window = grid.GetWindow();
  const double place = std::max({ -window[0], window[1], -window[2], window[3] });
  const glm::dmat4 dataToView = Columns(grid.GetWorldToView()) * Columns(volume.DataToWorld);
  const glm::dvec3 depthOfData(dataToView[0][2], dataToView[1][2], dataToView[2][2]);
  volume.LookAlong =
    length * grid.GetWidth(grid.GetEnd()) + StepsInFront * volume.StepLength * glm::length(depthOfData);
  volume.LookAside = length;
  if (grid.GetIsPerspective())
  {
    volume.LookAside = length < 1.0 ? (1.0 + place) * length / (1.0 - length) : VTK_DOUBLE_MAX;
  }
}

//------------------------------------------------------------------------------
void SetGatheringUniforms(const OpticsScene& scene, const vtkVisibilitySweep::Volume& volume,
  const SweepGrid& grid, bool isSwept, vtkShaderProgram* program)
{
  const glm::dmat4 textureToWorld = Columns(volume.TextureToWorld);
  const glm::dmat4 textureToView = Columns(grid.GetWorldToView()) * textureToWorld;
  const glm::dmat4 viewToTexture = glm::inverse(textureToView);
  const glm::dmat4 viewToData = glm::inverse(Columns(volume.DataToWorld)) * textureToWorld * viewToTexture;
  SetMatrix(program, "in_opticsGatherView", textureToView);
  SetMatrix(program, "in_opticsGatherWorld", textureToWorld);
  SetMatrix(program, "in_opticsGatherTexture", glm::dmat3(viewToTexture));
  const double unit = scene.Volume->GetProperty()->GetScalarOpacityUnitDistance();
  SetMatrix(program, "in_opticsGatherLengths", glm::dmat3(viewToData) / unit);
  SetScalarUniforms(scene, program);
  const int directions = scene.Mapper->GetVisibilitySamples();
  const int samples = scene.Mapper->GetVisibilityGatherSamples();
  SetWays(directions, scene.Optics->GetOcclusionAngle(), program);
  // half of the directions while the user interacts
  const int stride = std::min(scene.Mapper->GetCoarseness(), 2);
  const float numbers[4] = { static_cast<float>(directions), static_cast<float>(grid.GetSize()[2]),
    0.25F * static_cast<float>(directions), static_cast<float>(stride) };
  program->SetUniform4f("in_opticsGatherNumbers", numbers);
  const float gather[4] = { static_cast<float>(LengthOfRay(grid)),
    static_cast<float>(optics::FirstPartOfRay(samples)), grid.GetIsPerspective() ? 1.0F : 0.0F,
    isSwept ? 1.0F : 0.0F };
  program->SetUniform4f("in_opticsGather", gather);
}
