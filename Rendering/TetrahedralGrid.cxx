// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TetrahedralGrid.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGridBase.h"
#include "vtkUnstructuredGridVolumeMapper.h"

//------------------------------------------------------------------------------
TetrahedralGrid::TetrahedralGrid(vtkUnstructuredGridBase* grid, vtkDataArray* scalars)
  : Grid(grid)
  , Scalars(scalars)
  , Ghosts(grid->GetCellGhostArray())
{
}

//------------------------------------------------------------------------------
vtkDataArray* TetrahedralGrid::FindScalars(vtkUnstructuredGridVolumeMapper* mapper, bool& areOfCells)
{
  int cellFlag = 0;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(mapper->GetInput(), mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  areOfCells = cellFlag != 0;
  return scalars;
}

//------------------------------------------------------------------------------
vtkIdType TetrahedralGrid::GetNumberOfCells() const
{
  return this->Grid->GetNumberOfCells();
}

//------------------------------------------------------------------------------
bool TetrahedralGrid::IsTetrahedron(vtkIdType cell) const
{
  return this->Grid->GetCellType(cell) == VTK_TETRA;
}

//------------------------------------------------------------------------------
Tetrahedron TetrahedralGrid::GetTetrahedron(vtkIdType cell)
{
  this->Grid->GetCellPoints(cell, this->Points);
  std::array<glm::dvec3, 4> points;
  for (int i = 0; i < 4; ++i)
  {
    this->Grid->GetPoint(this->Points->GetId(i), &points[i][0]);
  }
  return Tetrahedron(points);
}

//------------------------------------------------------------------------------
glm::dvec4 TetrahedralGrid::GetScalars(vtkIdType cell)
{
  this->Grid->GetCellPoints(cell, this->Points);
  glm::dvec4 scalars;
  for (int i = 0; i < 4; ++i)
  {
    scalars[i] = this->Scalars->GetComponent(this->Points->GetId(i), 0);
  }
  return scalars;
}

//------------------------------------------------------------------------------
bool TetrahedralGrid::IsDrawn(vtkIdType cell)
{
  const int hidden = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  if (this->Ghosts && (this->Ghosts->GetValue(cell) & hidden) != 0)
  {
    return false;
  }
  const glm::dvec4 scalars = this->GetScalars(cell);
  const bool areNumbers = std::isfinite(scalars[0]) && std::isfinite(scalars[1]) &&
    std::isfinite(scalars[2]) && std::isfinite(scalars[3]);
  return areNumbers && this->GetTetrahedron(cell).HasVolume();
}
