// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TetrahedraVertices.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnstructuredGridBase.h"

#include <algorithm>
#include <utility>

namespace
{
// Of a tetrahedron whose first three edges are a right-hand system; seen from outside they run
// counterclockwise.
const unsigned int Faces[12] = { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };

vtkBoundingBox FiniteBounds(vtkUnstructuredGridBase* grid)
{
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double point[3];
    grid->GetPoint(i, point);
    if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
    {
      box.AddPoint(point);
    }
  }
  return box;
}
}

//------------------------------------------------------------------------------
bool TetrahedraVertices::Build(vtkUnstructuredGridBase* grid, vtkDataArray* scalars, const double range[2])
{
  this->Values.clear();
  this->FirstVertex.assign(grid->GetNumberOfCells(), -1);
  const vtkBoundingBox box = FiniteBounds(grid);
  if (!box.IsValid() || box.GetMaxLength() <= 0.0)
  {
    return false;
  }
  box.GetCenter(&this->Center[0]);
  this->Scale = box.GetMaxLength();
  TetrahedralGrid cells(grid, scalars);
  for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell)
  {
    if (!cells.IsTetrahedron(cell))
    {
      this->Values.clear();
      return true;
    }
    if (cells.IsDrawn(cell))
    {
      this->AddCell(cells, cell, range);
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TetrahedraVertices::AddCell(TetrahedralGrid& grid, vtkIdType cell, const double range[2])
{
  const Tetrahedron given = grid.GetTetrahedron(cell);
  std::array<glm::dvec3, 4> points = given.Points;
  glm::dvec4 scalars = (grid.GetScalars(cell) - range[0]) / (range[1] - range[0]);
  for (glm::dvec3& point : points)
  {
    point = (point - this->Center) / this->Scale;
  }
  if (given.SixfoldVolume < 0.0)
  {
    std::swap(points[2], points[3]);
    std::swap(scalars[2], scalars[3]);
  }
  const Tetrahedron local(points);
  const glm::dvec4 differences(
    scalars[0], scalars[1] - scalars[0], scalars[2] - scalars[0], scalars[3] - scalars[0]);
  this->FirstVertex[cell] = this->GetNumberOfVertices();
  for (const glm::dvec3& point : points)
  {
    this->AddVertex(point, differences, local);
  }
}

//------------------------------------------------------------------------------
void TetrahedraVertices::AddVertex(
  const glm::dvec3& position, const glm::dvec4& scalars, const Tetrahedron& local)
{
  const auto add = [this](double value) { this->Values.push_back(static_cast<float>(value)); };
  for (int i = 0; i < 3; ++i)
  {
    add(position[i]);
  }
  for (int i = 0; i < 4; ++i)
  {
    add(scalars[i]);
  }
  for (int weight = 1; weight < 4; ++weight)
  {
    for (int i = 0; i < 3; ++i)
    {
      add(local.WeightGradients[weight][i]);
    }
  }
}

//------------------------------------------------------------------------------
void TetrahedraVertices::AddFaces(vtkIdTypeArray* cells, std::vector<unsigned int>& indices) const
{
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    const vtkIdType first = this->FirstVertex[cells->GetValue(i)];
    for (int corner = 0; first >= 0 && corner < 12; ++corner)
    {
      indices.push_back(static_cast<unsigned int>(first) + Faces[corner]);
    }
  }
}
