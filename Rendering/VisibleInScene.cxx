// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibleInScene.h"

#include "SceneNeeds.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using Ends = VisibleScalars::Ends;

const int LeastTableWidth = 1024; // VTK's, and that of the terms' own opacity function

vtkPiecewiseFunction* OpacityFunction(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetScalarOpacity();
}

// As VTK keeps it.
void FindDataRange(const OpticsScene& scene, double range[2])
{
  scene.Scalars->GetFiniteRange(range, scene.OpacityComponent);
  range[0] = static_cast<float>(range[0]);
  range[1] = static_cast<float>(range[1]);
}

void FindTableRange(const OpticsScene& scene, double range[2])
{
  FindDataRange(scene, range);
  if (scene.Mapper->GetScalarOpacityRangeType() == vtkGPUVolumeRayCastMapper::NATIVE)
  {
    OpacityFunction(scene)->GetRange(range);
  }
}

// The scalars that coordinates 0 and 1 stand for: VTK takes codes of 8 and 16 bits for one more than there are.
void FindCoordinateRange(const OpticsScene& scene, double range[2])
{
  FindDataRange(scene, range);
  const bool isCode = scene.Scalars->GetDataTypeSize() <= 2;
  const double largest = isCode ? scene.Scalars->GetDataTypeMax() : 0.0;
  const double factor = isCode ? largest / (largest + 1.0) : 1.0;
  range[0] *= factor;
  range[1] *= factor;
}

VisibleScalars MakeVisible(const OpticsScene& scene, const std::vector<float>& table, Ends ends)
{
  double range[2];
  FindCoordinateRange(scene, range);
  return VisibleScalars(table, range, ends);
}

// VTK's look-up table.
std::vector<float> OpacityTable(const OpticsScene& scene)
{
  double range[2];
  FindTableRange(scene, range);
  const int wanted =
    vtkMath::NearestPowerOfTwo(OpacityFunction(scene)->EstimateMinNumberOfSamples(range[0], range[1]));
  const int largest = vtkTextureObject::GetMaximumTextureSize(scene.Window);
  std::vector<float> table(std::min(std::max(wanted, LeastTableWidth), std::max(largest, LeastTableWidth)));
  OpacityFunction(scene)->GetTable(range[0], range[1], static_cast<int>(table.size()), table.data());
  return table;
}

vtkImageData* Function2D(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetTransferFunction2D();
}

bool IsUsable2D(vtkImageData* function)
{
  return function && function->GetScalarType() == VTK_FLOAT && function->GetNumberOfScalarComponents() == 4 &&
    function->GetDimensions()[0] > 1;
}

// The largest opacity of a scalar, whatever the second coordinate; of its neighbours too, between which VTK
// interpolates when it resizes the image.
std::vector<float> OpacityTable2D(vtkImageData* function)
{
  const int* size = function->GetDimensions();
  const auto* texels = static_cast<const float*>(function->GetPointData()->GetScalars()->GetVoidPointer(0));
  std::vector<float> table(size[0], 0.0F);
  for (int texel = 0; texel < size[0] * size[1]; ++texel)
  {
    const int column = texel % size[0];
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, size[0] - 1); ++x)
    {
      table[x] = std::max(table[x], texels[4 * texel + 3]);
    }
  }
  return table;
}

// Entries that differ from zero where the function does somewhere between their neighbours: what an integral between
// any two entries, or a finer table, can see.
class WideTable
{
public:
  WideTable(int size, const double range[2])
    : Entries(size, 0.0F)
    , First(range[0])
    , Scale((size - 1.0) / (range[1] > range[0] ? range[1] - range[0] : 1.0))
  {
  }

  void Mark(double low, double high)
  {
    const double largest = this->Entries.size() - 1.0;
    const double begin = std::ceil((low - this->First) * this->Scale - 1.0);
    const double end = std::floor((high - this->First) * this->Scale + 1.0);
    if (begin <= largest && end >= 0.0)
    {
      std::fill(this->Entries.begin() + static_cast<int>(std::max(begin, 0.0)),
        this->Entries.begin() + static_cast<int>(std::min(end, largest)) + 1, 1.0F);
    }
  }

  std::vector<float> Entries;

private:
  double First;
  double Scale; // entries per scalar
};

void MarkFunction(vtkPiecewiseFunction* function, WideTable& table)
{
  const double outside = VTK_DOUBLE_MAX;
  double before[4] = { -outside, 0.0, 0.5, 0.0 }, node[4];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    before[1] = i == 0 && function->GetClamping() ? node[1] : before[1];
    if (before[1] > 0.0 || (i > 0 && node[1] > 0.0))
    {
      table.Mark(before[0], node[0]);
    }
    std::copy(node, node + 4, before);
  }
  if (before[1] > 0.0 && function->GetClamping())
  {
    table.Mark(before[0], outside);
  }
}

int TableSize(const OpticsScene& scene)
{
  return IsPreIntegrated(scene) ? scene.Mapper->GetPreIntegrationTableSize() : LeastTableWidth;
}

std::vector<float> IsosurfaceTable(const OpticsScene& scene)
{
  double range[2];
  FindDataRange(scene, range);
  WideTable table(TableSize(scene), range);
  for (int i = 0; HasIsosurfaces(scene) && i < scene.Optics->GetNumberOfIsosurfaces(); ++i)
  {
    const double value = scene.Optics->GetIsosurfaceValue(i);
    table.Mark(value, value);
  }
  return table.Entries;
}

// Of the integral in data space, or by a table.
std::vector<float> IntegralTable(const OpticsScene& scene)
{
  double range[2];
  FindTableRange(scene, range);
  WideTable table(TableSize(scene), range);
  MarkFunction(OpacityFunction(scene), table);
  const std::vector<float> surfaces = IsosurfaceTable(scene);
  std::transform(surfaces.begin(), surfaces.end(), table.Entries.begin(), table.Entries.begin(),
    [](float surface, float entry) { return std::max(surface, entry); });
  return table.Entries;
}
}

//------------------------------------------------------------------------------
bool IsSeenByScalars(const OpticsScene& scene)
{
  double range[2];
  FindDataRange(scene, range);
  const bool hasFunction =
    Is2D(scene) ? IsUsable2D(Function2D(scene)) : OpacityFunction(scene)->GetSize() > 0;
  return hasFunction && range[1] > range[0] && scene.Scalars->GetNumberOfComponents() != 3 &&
    !ReplacesClassification(scene) && !HasLabels(scene) && !scene.Mapper->GetUseDepthPass();
}

//------------------------------------------------------------------------------
VisibleScalars FindVisibleScalars(const OpticsScene& scene)
{
  if (ReplacesIntegral(scene))
  {
    VisibleScalars visible = MakeVisible(scene, IntegralTable(scene), Ends::Centres);
    visible.ShowNaN(); // on its two sides a segment may have numbers with visible ones between them
    return visible;
  }
  return MakeVisible(
    scene, Is2D(scene) ? OpacityTable2D(Function2D(scene)) : OpacityTable(scene), Ends::Edges);
}

//------------------------------------------------------------------------------
// A silhouette's opacity is that of a change along the gradient, which reaches beyond the cell.
VisibleScalars FindVisibleWhereConstant(const OpticsScene& scene)
{
  return IntegratesInData(scene) && !HasSilhouettes(scene)
    ? MakeVisible(scene, IsosurfaceTable(scene), Ends::Centres)
    : FindVisibleScalars(scene);
}
