// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibleInScene.h"

#include "ScalarCoordinates.h"
#include "SceneNeeds.h"
#include "VisibleGradients.h"
#include "VisibleIn2D.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using Ends = VisibleScalars::Ends;

const int IntegralTableSize = 1024; // that of the terms' own opacity function

vtkPiecewiseFunction* OpacityFunction(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetScalarOpacity();
}

void FindTableRange(const OpticsScene& scene, double range[2])
{
  FindDataRange(scene, range);
  if (scene.Mapper->GetScalarOpacityRangeType() == vtkGPUVolumeRayCastMapper::NATIVE)
  {
    OpacityFunction(scene)->GetRange(range);
  }
}

VisibleScalars MakeVisible(const OpticsScene& scene, const std::vector<float>& table, Ends ends,
  const std::vector<float>& leastGradients = {})
{
  double range[2];
  FindCoordinateRange(scene, range);
  return VisibleScalars(table, range, ends, leastGradients);
}

// What VTK's look-up tables show, that of gradients, too.
VisibleScalars FindVisibleIn1D(const OpticsScene& scene)
{
  double range[2];
  FindTableRange(scene, range);
  const std::vector<float> table = MakeVTKTable(scene, OpacityFunction(scene), range, range[0], range[1]);
  if (!IsSeenByGradients(scene))
  {
    return MakeVisible(scene, table, Ends::Edges);
  }
  const std::vector<float> gradients = MakeGradientTable(scene);
  const float least = static_cast<float>(FindLeastGradient(scene, gradients));
  VisibleScalars visible = MakeVisible(scene, table, Ends::Edges, std::vector<float>(table.size(), least));
  visible.SetGradientOpacities(gradients);
  return visible;
}

VisibleScalars FindVisibleIn2D(const OpticsScene& scene)
{
  const Columns2D columns = FindColumns2D(scene);
  return MakeVisible(scene, columns.Opacities, Ends::Edges, columns.LeastGradients);
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
  return IsPreIntegrated(scene) ? scene.Mapper->GetPreIntegrationTableSize() : IntegralTableSize;
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
  const bool hasFunction = Is2D(scene) ? IsUsable2D(scene) : OpacityFunction(scene)->GetSize() > 0;
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
  return Is2D(scene) ? FindVisibleIn2D(scene) : FindVisibleIn1D(scene);
}

//------------------------------------------------------------------------------
// A silhouette's opacity is that of a change along the gradient, which reaches beyond the cell.
VisibleScalars FindVisibleWhereConstant(const OpticsScene& scene)
{
  return IntegratesInData(scene) && !HasSilhouettes(scene)
    ? MakeVisible(scene, IsosurfaceTable(scene), Ends::Centres)
    : FindVisibleScalars(scene);
}
