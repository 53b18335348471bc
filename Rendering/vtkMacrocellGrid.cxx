// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMacrocellGrid.h"

#include "MacrocellDistances.h"
#include "MacrocellGradients.h"
#include "MacrocellRanges.h"
#include "VisibleScalars.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>

vtkStandardNewMacro(vtkMacrocellGrid);

namespace
{
const int MostBatches = 25; // progress is told between two of them
const int LeastBatches = 4;
const int LeastCellSize = 2;
const int LargestCellSize = 64;
const double MostAutomaticCells = 262144.0;

double CountCells(const int dimensions[3], int cellSize)
{
  double cells = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int onAxis = (dimensions[axis] + cellSize - 1) / cellSize;
    cells *= onAxis;
  }
  return cells;
}
}

//------------------------------------------------------------------------------
vtkMacrocellGrid::vtkMacrocellGrid() = default;

//------------------------------------------------------------------------------
vtkMacrocellGrid::~vtkMacrocellGrid() = default;

//------------------------------------------------------------------------------
int vtkMacrocellGrid::FindCellSize(const int dimensions[3])
{
  int cellSize = LeastCellSize;
  while (cellSize < LargestCellSize && CountCells(dimensions, cellSize) > MostAutomaticCells)
  {
    cellSize *= 2;
  }
  return cellSize;
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::SetScalars(vtkDataArray* scalars)
{
  if (this->Scalars != scalars)
  {
    this->Scalars = scalars;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataArray* vtkMacrocellGrid::GetScalars()
{
  return this->Scalars;
}

//------------------------------------------------------------------------------
std::size_t vtkMacrocellGrid::Index(int i, int j, int k) const
{
  return (static_cast<std::size_t>(k) * this->GridSize[1] + j) * this->GridSize[0] + i;
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::GetCellRange(int i, int j, int k, double range[2])
{
  range[0] = this->Lowest[this->Index(i, j, k)];
  range[1] = this->Highest[this->Index(i, j, k)];
}

//------------------------------------------------------------------------------
bool vtkMacrocellGrid::GetCellHasNonFinite(int i, int j, int k)
{
  return this->NonFinite[this->Index(i, j, k)] != 0;
}

//------------------------------------------------------------------------------
float vtkMacrocellGrid::GetCellGradient(int i, int j, int k)
{
  return this->Gradients.empty() ? 1.0F : this->Gradients[this->Index(i, j, k)];
}

//------------------------------------------------------------------------------
int vtkMacrocellGrid::GetCellDistance(int i, int j, int k)
{
  return this->Distances[this->Index(i, j, k)];
}

//------------------------------------------------------------------------------
std::size_t vtkMacrocellGrid::GetMemorySize()
{
  return (this->Lowest.size() * 2 + this->Gradients.size()) * sizeof(float) + this->NonFinite.size() +
    this->Distances.size();
}

//------------------------------------------------------------------------------
bool vtkMacrocellGrid::IsUsable()
{
  const int* size = this->Dimensions;
  return this->Scalars && this->Scalars->GetDataType() != VTK_BIT &&
    std::min({ size[0], size[1], size[2] }) > 0 &&
    static_cast<vtkIdType>(size[0]) * size[1] * size[2] == this->Scalars->GetNumberOfTuples() &&
    this->Component < this->Scalars->GetNumberOfComponents();
}

//------------------------------------------------------------------------------
bool vtkMacrocellGrid::Update()
{
  const vtkMTimeType scalarsTime = this->Scalars ? this->Scalars->GetMTime() : 0;
  if (this->UpdateTime > this->GetMTime() && this->UpdateTime > scalarsTime)
  {
    return !this->Lowest.empty();
  }
  this->UpdateTime.Modified();
  const bool isUsable = this->IsUsable();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->GridSize[axis] = isUsable ? (this->Dimensions[axis] + this->CellSize - 1) / this->CellSize : 0;
  }
  const std::size_t cells = this->Index(0, 0, this->GridSize[2]);
  this->Lowest.assign(cells, 0.0F);
  this->Highest.assign(cells, 0.0F);
  this->NonFinite.assign(cells, 0);
  this->Gradients.clear();
  this->Distances.assign(cells, 0);
  this->EmptyFraction = 0.0;
  this->DeepEmptyFraction = 0.0;
  if (!isUsable)
  {
    vtkErrorMacro(<< "There are no scalars of dimensions " << this->Dimensions[0] << " x "
                  << this->Dimensions[1] << " x " << this->Dimensions[2] << " with a component "
                  << this->Component << ". Set scalars, dimensions and component that belong together.");
    return false;
  }
  this->InvokeEvent(vtkCommand::StartEvent);
  this->FindRanges();
  this->InvokeEvent(vtkCommand::EndEvent);
  return true;
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::UpdateGradients()
{
  if (this->Gradients.empty() && !this->Lowest.empty())
  {
    this->Gradients.assign(this->Lowest.size(), 1.0F);
    this->InvokeEvent(vtkCommand::StartEvent);
    this->FindGradients();
    this->InvokeEvent(vtkCommand::EndEvent);
  }
}

//------------------------------------------------------------------------------
namespace
{
// find(layer), by all threads; progress is told between batches.
template <typename Function>
void FindLayers(vtkMacrocellGrid* grid, Function find)
{
  const vtkIdType layers = grid->GetGridSize()[2];
  // a layer for each thread, while there are some batches left to tell progress between
  const vtkIdType threads =
    std::min<vtkIdType>(vtkSMPTools::GetEstimatedNumberOfThreads(), layers / LeastBatches);
  const vtkIdType batch = std::max({ layers / MostBatches, threads, vtkIdType(1) });
  for (vtkIdType begin = 0; begin < layers; begin += batch)
  {
    const vtkIdType end = std::min(begin + batch, layers);
    vtkSMPTools::For(begin, end, 1, [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType layer = first; layer < last; ++layer)
      {
        find(static_cast<int>(layer));
      }
    });
    double progress = static_cast<double>(end) / layers;
    grid->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  }
}

template <typename Scalar>
const Scalar* FirstScalar(vtkDataArray* scalars, int component)
{
  return static_cast<const Scalar*>(scalars->GetVoidPointer(0)) + component;
}
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::FindRanges()
{
  const volumeoptics::MacrocellLattice lattice(this->Dimensions, this->CellSize);
  const auto findOf = [&](const auto& layers) {
    FindLayers(this, [&](int layer) {
      const volumeoptics::MacrocellRow cells = layers.Find(layer);
      const std::size_t offset = layer * cells.Lowest.size();
      std::copy(cells.Lowest.begin(), cells.Lowest.end(), this->Lowest.begin() + offset);
      std::copy(cells.Highest.begin(), cells.Highest.end(), this->Highest.begin() + offset);
      std::copy(cells.NonFinite.begin(), cells.NonFinite.end(), this->NonFinite.begin() + offset);
    });
  };
  const int components = this->Scalars->GetNumberOfComponents();
  switch (this->Scalars->GetDataType())
  {
    vtkTemplateMacro(findOf(volumeoptics::MacrocellLayer<VTK_TT>(
      FirstScalar<VTK_TT>(this->Scalars, this->Component), components, lattice)));
  }
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::FindGradients()
{
  const volumeoptics::MacrocellLattice lattice(this->Dimensions, this->CellSize);
  const auto findOf = [&](const auto& layers) {
    FindLayers(this, [&](int layer) {
      const std::vector<float> magnitudes = layers.Find(layer);
      std::copy(magnitudes.begin(), magnitudes.end(), this->Gradients.begin() + layer * magnitudes.size());
    });
  };
  const int components = this->Scalars->GetNumberOfComponents();
  switch (this->Scalars->GetDataType())
  {
    vtkTemplateMacro(findOf(volumeoptics::MacrocellGradients<VTK_TT>(
      FirstScalar<VTK_TT>(this->Scalars, this->Component), components, lattice, this->GradientScale)));
  }
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::Classify(const VisibleScalars& visible, const VisibleScalars& visibleWhereConstant)
{
  const bool showsNaN = visible.HasNaN();
  std::atomic<vtkIdType> empty{ 0 };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Lowest.size()), [&](vtkIdType begin, vtkIdType end) {
    vtkIdType count = 0;
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      const float low = this->Lowest[cell], high = this->Highest[cell];
      const VisibleScalars& seen = low == high ? visibleWhereConstant : visible;
      const float gradient = this->Gradients.empty() ? 1.0F : this->Gradients[cell];
      const bool hidesNumbers = low > high || !seen.HasAny(low, high, gradient);
      const bool isEmpty = hidesNumbers && (this->NonFinite[cell] == 0 || !showsNaN);
      this->Distances[cell] = isEmpty ? 1 : 0;
      count += isEmpty ? 1 : 0;
    }
    empty += count;
  });
  volumeoptics::FindMacrocellDistances(this->GridSize, this->Distances);
  const auto deep = std::count_if(
    this->Distances.begin(), this->Distances.end(), [](unsigned char distance) { return distance > 1; });
  const double cells = std::max<double>(static_cast<double>(this->Lowest.size()), 1.0);
  this->EmptyFraction = static_cast<double>(empty) / cells;
  this->DeepEmptyFraction = static_cast<double>(deep) / cells;
  this->FindVisibleExtent();
  this->ClassifyTime.Modified();
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::FindVisibleExtent()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->VisibleExtent[2 * axis] = this->GridSize[axis];
    this->VisibleExtent[2 * axis + 1] = -1;
  }
  const unsigned char* distance = this->Distances.data();
  int cell[3];
  for (cell[2] = 0; cell[2] < this->GridSize[2]; ++cell[2])
  {
    for (cell[1] = 0; cell[1] < this->GridSize[1]; ++cell[1])
    {
      for (cell[0] = 0; cell[0] < this->GridSize[0]; ++cell[0], ++distance)
      {
        for (int axis = 0; axis < 3 && *distance == 0; ++axis)
        {
          int* extent = this->VisibleExtent + 2 * axis;
          extent[0] = std::min(extent[0], cell[axis]);
          extent[1] = std::max(extent[1], cell[axis]);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkMacrocellGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "Scalars: " << this->Scalars << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "GradientScale: " << this->GradientScale[0] << " " << this->GradientScale[1] << " "
     << this->GradientScale[2] << "\n";
  os << indent << "GridSize: " << this->GridSize[0] << " " << this->GridSize[1] << " " << this->GridSize[2]
     << "\n";
  os << indent << "VisibleExtent:";
  for (const int cell : this->VisibleExtent)
  {
    os << " " << cell;
  }
  os << "\n" << indent << "EmptyFraction: " << this->EmptyFraction << "\n";
  os << indent << "DeepEmptyFraction: " << this->DeepEmptyFraction << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
}
