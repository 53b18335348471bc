// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The tetrahedra of an unstructured grid with their scalars, as far as they can be drawn: without
// those that are flat, have a scalar that is no number, are ghosts or are blanked.

#ifndef TetrahedralGrid_h
#define TetrahedralGrid_h

#include "Tetrahedron.h"

#include "vtkNew.h"
#include "vtkType.h"

class vtkDataArray;
class vtkIdList;
class vtkUnsignedCharArray;
class vtkUnstructuredGridBase;
class vtkUnstructuredGridVolumeMapper;

class TetrahedralGrid
{
public:
  // scalars: of the points, the first component counts
  TetrahedralGrid(vtkUnstructuredGridBase* grid, vtkDataArray* scalars);

  // What a mapper is told to draw; null without.
  static vtkDataArray* FindScalars(vtkUnstructuredGridVolumeMapper* mapper, bool& areOfCells);

  vtkIdType GetNumberOfCells() const;
  bool IsTetrahedron(vtkIdType cell) const;

  // Only for tetrahedra.
  Tetrahedron GetTetrahedron(vtkIdType cell);
  glm::dvec4 GetScalars(vtkIdType cell);
  bool IsDrawn(vtkIdType cell);

private:
  vtkUnstructuredGridBase* Grid;
  vtkDataArray* Scalars;
  vtkUnsignedCharArray* Ghosts;
  vtkNew<vtkIdList> Points;
};

#endif
