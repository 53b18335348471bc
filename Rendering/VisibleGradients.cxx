// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibleGradients.h"

#include "ScalarCoordinates.h"
#include "SceneNeeds.h"
#include "VisibleScalars.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
const double RangePart = 0.25; // VTK's

// Roundings of the scalar's largest value: three interpolations, scale and bias in both of two look-ups, and back.
const double Roundings = 16.0;
}

//------------------------------------------------------------------------------
bool IsSeenByGradients(const OpticsScene& scene)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  // VTK gives an empty function two points when it draws
  const bool hasFunction =
    Is2D(scene) || (HasGradientOpacity(scene) && property->GetGradientOpacity()->GetSize() > 0);
  double scale[3];
  FindGradientScale(scene, scale);
  return hasFunction && !ReplacesIntegral(scene) && *std::min_element(scale, scale + 3) > 0.0 &&
    property->GetInterpolationType() == VTK_LINEAR_INTERPOLATION &&
    !property->GetUseClippedVoxelIntensity() && scene.Scalars->GetNumberOfComponents() == 1 &&
    !scene.Mapper->GetTransfer2DYAxisArray();
}

//------------------------------------------------------------------------------
void FindGradientScale(const OpticsScene& scene, double scale[3])
{
  double range[2];
  FindCoordinateRange(scene, range);
  const double* spacing = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetSpacing();
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double magnitude = mean / (2.0 * spacing[axis]) / (RangePart * (range[1] - range[0]));
    scale[axis] = std::isfinite(magnitude) ? magnitude : 0.0;
  }
}

//------------------------------------------------------------------------------
double FindGradientSlack(const OpticsScene& scene)
{
  double range[2], scale[3];
  FindCoordinateRange(scene, range);
  FindGradientScale(scene, scale);
  const double largest = std::max(std::abs(range[0]), std::abs(range[1])) + range[1] - range[0];
  return Roundings * std::numeric_limits<float>::epsilon() * largest *
    std::hypot(scale[0], scale[1], scale[2]);
}

//------------------------------------------------------------------------------
std::vector<float> MakeGradientTable(const OpticsScene& scene)
{
  vtkPiecewiseFunction* function = scene.Volume->GetProperty()->GetGradientOpacity();
  double range[2];
  FindDataRange(scene, range);
  if (scene.Mapper->GetGradientOpacityRangeType() == vtkGPUVolumeRayCastMapper::NATIVE)
  {
    function->GetRange(range);
  }
  return MakeVTKTable(scene, function, range, 0.0, RangePart * (range[1] - range[0]));
}

//------------------------------------------------------------------------------
double FindLeastGradient(const OpticsScene& scene, const std::vector<float>& table)
{
  const auto seen =
    std::find_if_not(table.begin(), table.end(), [](float opacity) { return opacity <= 0.0F; });
  if (seen == table.end())
  {
    return std::numeric_limits<double>::infinity();
  }
  // the texture's linear interpolation sees an entry from the middle of the one before on
  const double entry = static_cast<double>(seen - table.begin()) - 0.5 - VisibleScalars::LookUpSlack;
  return std::max(entry / static_cast<double>(table.size()) - FindGradientSlack(scene), 0.0);
}
