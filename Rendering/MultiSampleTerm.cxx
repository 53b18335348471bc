// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MultiSampleTerm.h"

#include "FrameTerm.h"
#include "RayUniforms.h"
#include "ScalarPair.h"
#include "SceneNeeds.h"
#include "vtkMultiSampleClassification.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <vector>

namespace
{
// To the coordinate in which the shader has scalars; what is beyond a float's range is beyond all data.
float Coordinate(double number, double origin, double width)
{
  return static_cast<float>(std::clamp((number - origin) / width, -1.0e30, 1.0e30));
}

void ToCoordinates(std::vector<float>& rules, const double range[2])
{
  const double width = range[1] - range[0];
  for (std::size_t rule = 0; rule < rules.size(); rule += vtkMultiSampleClassification::NumbersOfRule)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      rules[rule + i] = Coordinate(rules[rule + i], range[0], width);
      rules[rule + 4 + i] = Coordinate(rules[rule + 4 + i], range[0], width);
      rules[rule + 8 + i] = Coordinate(rules[rule + 8 + i], 0.0, width);
    }
  }
}
}

//------------------------------------------------------------------------------
bool MultiSampleTerm::IsActive(const OpticsScene& scene)
{
  if (!WantsClassification(scene))
  {
    return false;
  }
  const std::string reason = FindUnsupportedByClassification(scene);
  if (!reason.empty())
  {
    scene.Mapper->Say("The classification by several samples does not support " + reason +
      ": colour and opacity are those of the transfer functions. SetMultiSampleClassification(nullptr) "
      "silences this.");
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool MultiSampleTerm::Prepare(const OpticsScene& scene)
{
  return this->Frames.Serves(scene);
}

//------------------------------------------------------------------------------
void MultiSampleTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(OpticsFeature::MultiSample);
  features.Add(OpticsFeature::OpacityFormulas);
  features.Add(OpticsFeature::SampleScalar);
  AddScalarPairFeatures(scene, features);
}

//------------------------------------------------------------------------------
void MultiSampleTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  double range[2];
  CoordinateRange(scene, range);
  std::vector<float> rules;
  scene.Optics->GetMultiSampleClassification()->GetRules(rules);
  ToCoordinates(rules, range);
  const auto vectors = static_cast<int>(rules.size() / 4);
  if (vectors > 0 && program->IsUniformUsed("in_opticsRules"))
  {
    program->SetUniform4fv("in_opticsRules", vectors, reinterpret_cast<const float(*)[4]>(rules.data()));
  }
  program->SetUniformi("in_opticsNumberOfRules", vectors * 4 / vtkMultiSampleClassification::NumbersOfRule);
  program->SetUniformf("in_opticsUnitDistance", static_cast<float>(UnitDistance(scene)));
  SetScalarUniforms(scene, program);
  SetScalarPairUniforms(scene, program);
}
