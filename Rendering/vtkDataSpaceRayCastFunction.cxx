// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDataSpaceRayCastFunction.h"

#include "TetrahedralGrid.h"
#include "vtkDataSpaceRayIntegrator.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGridBase.h"
#include "vtkUnstructuredGridVolumeRayCastIterator.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkVolume.h"

namespace
{
glm::dmat3 LinearPart(vtkMatrix4x4* matrix)
{
  glm::dmat3 linear;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      linear[column][row] = matrix->GetElement(row, column);
    }
  }
  return linear;
}

// VTK's iterator with other lengths.
class GradientIterator : public vtkUnstructuredGridVolumeRayCastIterator
{
public:
  static GradientIterator* New();
  vtkTypeMacro(GradientIterator, vtkUnstructuredGridVolumeRayCastIterator);

  void SetSource(vtkDataSpaceRayCastFunction* function, vtkUnstructuredGridVolumeRayCastIterator* cells)
  {
    this->Function = function;
    this->Cells = cells;
  }

  void Initialize(int x, int y) override
  {
    this->LengthScale = this->Function->GetLengthScale(x, y);
    this->Cells->SetBounds(this->Bounds);
    this->Cells->SetMaxNumberOfIntersections(this->MaxNumberOfIntersections);
    this->Cells->Initialize(x, y);
  }

  vtkIdType GetNextIntersections(vtkIdList* intersectedCells, vtkDoubleArray* intersectionLengths,
    vtkDataArray* scalars, vtkDataArray* nearIntersections, vtkDataArray* farIntersections) override
  {
    vtkIdList* ids = intersectedCells ? intersectedCells : this->Ids.GetPointer();
    const vtkIdType count = this->Cells->GetNextIntersections(
      ids, intersectionLengths, scalars, nearIntersections, farIntersections);
    for (vtkIdType i = 0; intersectionLengths && i < count; ++i)
    {
      const double factor = this->LengthScale * this->Function->GetGradientMagnitude(ids->GetId(i));
      intersectionLengths->SetValue(i, intersectionLengths->GetValue(i) * factor);
    }
    return count;
  }

protected:
  GradientIterator() = default;

private:
  vtkDataSpaceRayCastFunction* Function = nullptr;
  vtkSmartPointer<vtkUnstructuredGridVolumeRayCastIterator> Cells;
  vtkNew<vtkIdList> Ids;
  double LengthScale = 1.0;
};
vtkStandardNewMacro(GradientIterator);
}

vtkStandardNewMacro(vtkDataSpaceRayCastFunction);

//------------------------------------------------------------------------------
void vtkDataSpaceRayCastFunction::Initialize(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Superclass::Initialize(renderer, volume);
  auto* property = vtkOpticsVolumeProperty::SafeDownCast(volume->GetProperty());
  const bool hasSilhouettes = property && property->GetSilhouette() != vtkOpticsVolumeProperty::SilhouetteOff;
  this->MultipliesByGradient = this->Valid && hasSilhouettes &&
    vtkDataSpaceRayIntegrator::SafeDownCast(this->Mapper->GetRayIntegrator());
  if (this->MultipliesByGradient)
  {
    this->ComputeGradientMagnitudes();
  }
}

//------------------------------------------------------------------------------
void vtkDataSpaceRayCastFunction::ComputeGradientMagnitudes()
{
  vtkUnstructuredGridBase* input = this->Mapper->GetInput();
  this->GradientMagnitudes.assign(input->GetNumberOfCells(), 0.0);
  bool areOfCells = false;
  vtkDataArray* scalars = TetrahedralGrid::FindScalars(this->Mapper, areOfCells);
  if (!scalars || areOfCells)
  {
    return;
  }
  const glm::dmat3 gradientToWorld = glm::inverse(glm::transpose(LinearPart(this->Volume->GetMatrix())));
  TetrahedralGrid grid(input, scalars);
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    if (grid.IsTetrahedron(cell) && grid.IsDrawn(cell))
    {
      const glm::dvec3 gradient = grid.GetTetrahedron(cell).GetGradient(grid.GetScalars(cell));
      this->GradientMagnitudes[cell] = glm::length(gradientToWorld * gradient);
    }
  }
}

//------------------------------------------------------------------------------
double vtkDataSpaceRayCastFunction::GetLengthScale(int x, int y) const
{
  const double device[2] = { 2.0 * x / (this->ImageViewportSize[0] - 1) - 1.0,
    2.0 * y / (this->ImageViewportSize[1] - 1) - 1.0 };
  glm::dvec3 ends[2];
  for (int end = 0; end < 2; ++end)
  {
    double point[4] = { device[0], device[1], static_cast<double>(end), 1.0 };
    this->ViewToWorldMatrix->MultiplyPoint(point, point);
    ends[end] = glm::dvec3(point[0], point[1], point[2]) / point[3];
  }
  const glm::dvec3 ray = ends[1] - ends[0];
  return glm::length(LinearPart(this->Volume->GetMatrix()) * ray) / glm::length(ray);
}

//------------------------------------------------------------------------------
vtkUnstructuredGridVolumeRayCastIterator* vtkDataSpaceRayCastFunction::NewIterator()
{
  vtkUnstructuredGridVolumeRayCastIterator* cells = this->Superclass::NewIterator();
  if (!cells || !this->MultipliesByGradient)
  {
    return cells;
  }
  GradientIterator* iterator = GradientIterator::New();
  iterator->SetSource(this, cells);
  cells->Delete();
  return iterator;
}

//------------------------------------------------------------------------------
void vtkDataSpaceRayCastFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MultipliesByGradient: " << (this->MultipliesByGradient ? "On" : "Off") << "\n";
}
