// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ScalarCoordinates.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
const int LeastTableSize = 1024; // VTK's
}

//------------------------------------------------------------------------------
void FindDataRange(const OpticsScene& scene, double range[2])
{
  scene.Scalars->GetFiniteRange(range, scene.OpacityComponent);
  range[0] = static_cast<float>(range[0]);
  range[1] = static_cast<float>(range[1]);
}

//------------------------------------------------------------------------------
void FindCoordinateRange(const OpticsScene& scene, double range[2])
{
  FindDataRange(scene, range);
  const bool isCode = scene.Scalars->GetDataTypeSize() <= 2;
  const double largest = isCode ? scene.Scalars->GetDataTypeMax() : 0.0;
  const double factor = isCode ? largest / (largest + 1.0) : 1.0;
  range[0] *= factor;
  range[1] *= factor;
}

//------------------------------------------------------------------------------
int FindTableSize(const OpticsScene& scene, int wanted)
{
  const int largest = std::max(vtkTextureObject::GetMaximumTextureSize(scene.Window), LeastTableSize);
  return std::clamp(vtkMath::NearestPowerOfTwo(wanted), LeastTableSize, largest);
}

//------------------------------------------------------------------------------
std::vector<float> MakeVTKTable(
  const OpticsScene& scene, vtkPiecewiseFunction* function, const double range[2], double first, double last)
{
  const int wanted = function->EstimateMinNumberOfSamples(range[0], range[1]);
  std::vector<float> table(FindTableSize(scene, wanted));
  function->GetTable(first, last, static_cast<int>(table.size()), table.data());
  return table;
}
