// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Tetrahedra as the vertices that ProjectedTetrahedraVertex.glsl reads: four a tetrahedron, the
// right-hand way round, in a unit box. They do not depend on the view.

#ifndef TetrahedraVertices_h
#define TetrahedraVertices_h

#include "TetrahedralGrid.h"

#include "vtkType.h"

#include <vector>

class vtkIdTypeArray;
class vtkUnstructuredGridBase;

class TetrahedraVertices
{
public:
  // Floats of a vertex: position, scalars, three gradients of weights.
  static constexpr int Stride = 16;
  static constexpr int ScalarsOffset = 3;
  static constexpr int GradientsOffset = 7;

  // range: of the scalars, not empty. Returns whether there is another kind of cell; then no
  // vertices are left.
  bool Build(vtkUnstructuredGridBase* grid, vtkDataArray* scalars, const double range[2]);

  bool IsEmpty() const { return this->Values.empty(); }
  const std::vector<float>& GetValues() const { return this->Values; }
  vtkIdType GetNumberOfVertices() const { return static_cast<vtkIdType>(this->Values.size()) / Stride; }

  // Adds the faces of cells to a list of triangles that look outwards.
  void AddFaces(vtkIdTypeArray* cells, std::vector<unsigned int>& indices) const;

  // From the unit box to the grid's coordinates.
  const glm::dvec3& GetCenter() const { return this->Center; }
  double GetScale() const { return this->Scale; }

private:
  void AddCell(TetrahedralGrid& grid, vtkIdType cell, const double range[2]);
  void AddVertex(const glm::dvec3& position, const glm::dvec4& scalars, const Tetrahedron& local);

  std::vector<float> Values;
  std::vector<vtkIdType> FirstVertex; // of each cell, -1 for those not drawn
  glm::dvec3 Center = glm::dvec3(0.0);
  double Scale = 1.0;
};

#endif
