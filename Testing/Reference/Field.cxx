// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

namespace reference
{
//------------------------------------------------------------------------------
GridField::GridField(vtkImageData* image, int component)
  : Scalars(image, image->GetPointData()->GetScalars())
  , Component(component)
{
}

//------------------------------------------------------------------------------
Vector GridField::Gradient(const Vector& point) const
{
  const Grid& grid = this->GetGrid();
  Vector gradient(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector step = grid.Step(axis);
    const double difference = this->Value(point + step) - this->Value(point - step);
    gradient += grid.directions[axis] * (difference / (2.0 * grid.spacing[axis]));
  }
  return gradient;
}
}
