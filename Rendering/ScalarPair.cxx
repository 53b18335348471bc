// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ScalarPair.h"

#include "RayUniforms.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkShaderProgram.h"

namespace
{
bool FetchesPair(const OpticsScene& scene)
{
  return scene.Mapper->GetLightingSamples() == vtkOpticsVolumeMapper::Fetched;
}

// A step along a unit vector of data space, to voxels. A matrix set by rows is transposed for OpenGL.
void SetStepToVoxels(const OpticsScene& scene, vtkShaderProgram* program)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const double step = scene.Optics->GetGradientStepLength() * SmallestSpacing(scene);
  vtkNew<vtkMatrix3x3> transposed;
  for (int i = 0; i < 9; ++i)
  {
    const double voxels = step / image->GetSpacing()[i % 3];
    transposed->SetElement(i / 3, i % 3, image->GetDirectionMatrix()->GetElement(i / 3, i % 3) * voxels);
  }
  program->SetUniformMatrix("in_opticsStepToVoxels", transposed);
}
}

//------------------------------------------------------------------------------
void AddScalarPairFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  if (FetchesPair(scene))
  {
    features.Add(OpticsFeature::ScalarLookup);
    features.Add(OpticsFeature::ScalarPairFetched);
  }
  else
  {
    features.Add(OpticsFeature::ScalarPairExtrapolated);
  }
}

//------------------------------------------------------------------------------
void SetScalarPairUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  if (FetchesPair(scene))
  {
    SetStepToVoxels(scene, program);
  }
  else
  {
    program->SetUniformf("in_opticsPairStep", static_cast<float>(scene.Optics->GetGradientStepLength()));
  }
}
