// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDataSpaceRayIntegrator.h"

#include "DataSpaceClassification.h"
#include "ParameterRange.h"
#include "TetrahedralGrid.h"
#include "vtkDataSpaceRayCastFunction.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

vtkStandardNewMacro(vtkDataSpaceRayIntegrator);

namespace
{
bool MultipliesByGradient(vtkVolume* volume)
{
  auto* mapper = vtkUnstructuredGridVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  auto* function = mapper ? vtkDataSpaceRayCastFunction::SafeDownCast(mapper->GetRayCastFunction()) : nullptr;
  return function && function->GetMultipliesByGradient();
}

bool HasCellScalars(vtkVolume* volume)
{
  auto* mapper = vtkUnstructuredGridVolumeMapper::SafeDownCast(volume->GetMapper());
  bool areOfCells = false;
  return mapper && TetrahedralGrid::FindScalars(mapper, areOfCells) && areOfCells;
}
}

//------------------------------------------------------------------------------
vtkDataSpaceRayIntegrator::vtkDataSpaceRayIntegrator()
  : Classification(std::make_unique<DataSpaceClassification>())
{
}

//------------------------------------------------------------------------------
vtkDataSpaceRayIntegrator::~vtkDataSpaceRayIntegrator() = default;

//------------------------------------------------------------------------------
void vtkDataSpaceRayIntegrator::SetTableSize(int size)
{
  volumeoptics::SetWithinRange(this, "TableSize", size, 2, 4096, this->TableSize);
}

//------------------------------------------------------------------------------
void vtkDataSpaceRayIntegrator::Initialize(vtkVolume* volume, vtkDataArray* scalars)
{
  scalars->GetFiniteRange(this->Range, 0);
  this->IsVisible = this->Range[0] < this->Range[1];
  if (this->IsVisible)
  {
    this->Classification->Update(volume->GetProperty(), this->Range, this->TableSize);
    this->HasGradientSteps = MultipliesByGradient(volume);
    this->Check(volume, scalars);
    this->IsVisible = this->Classification->IsValid();
  }
}

//------------------------------------------------------------------------------
void vtkDataSpaceRayIntegrator::WarnOnce(bool& isSaid, const char* text)
{
  if (!isSaid)
  {
    vtkWarningMacro(<< text);
    isSaid = true;
  }
}

//------------------------------------------------------------------------------
void vtkDataSpaceRayIntegrator::Check(vtkVolume* volume, vtkDataArray* scalars)
{
  if (this->Classification->HasSilhouettes() && !this->HasGradientSteps)
  {
    this->WarnOnce(this->IsSilhouetteWarned,
      "Silhouettes are drawn with a vtkDataSpaceRayCastFunction alone, which knows the cells' gradients: "
      "hand one to vtkUnstructuredGridVolumeRayCastMapper::SetRayCastFunction(). Drawn without.");
  }
  if (scalars->GetNumberOfComponents() > 1 || !volume->GetProperty()->GetIndependentComponents())
  {
    this->WarnOnce(this->IsComponentWarned,
      "The scalars have several components, or dependent ones; the first is drawn, as independent.");
  }
  if (HasCellScalars(volume))
  {
    this->WarnOnce(this->IsCellWarned,
      "Scalars of the cells are constant in each cell, and so are not seen in data space. Use "
      "vtkCellDataToPointData.");
  }
}

//------------------------------------------------------------------------------
void vtkDataSpaceRayIntegrator::Integrate(vtkDoubleArray* intersectionLengths,
  vtkDataArray* nearIntersections, vtkDataArray* farIntersections, float color[4])
{
  const double width = this->Range[1] - this->Range[0];
  glm::dvec4 front(color[0], color[1], color[2], color[3]);
  const vtkIdType segments = this->IsVisible ? nearIntersections->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < segments; ++i)
  {
    const double length = intersectionLengths->GetValue(i);
    const double nearScalar = this->Classification->Normalize(nearIntersections->GetComponent(i, 0));
    const double farScalar = this->Classification->Normalize(farIntersections->GetComponent(i, 0));
    if (std::isfinite(nearScalar) && std::isfinite(farScalar) && std::isfinite(length))
    {
      const double gradientStep = this->HasGradientSteps ? length / width : 0.0;
      const glm::dvec4 segment = this->Classification->GetSegmentColor(nearScalar, farScalar, gradientStep);
      front += (1.0 - front[3]) * segment;
    }
  }
  for (int channel = 0; channel < 4; ++channel)
  {
    color[channel] = static_cast<float>(front[channel]);
  }
}

//------------------------------------------------------------------------------
void vtkDataSpaceRayIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TableSize: " << this->TableSize << "\n";
}
