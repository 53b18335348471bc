// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineColors.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace
{
// From the point before to the one behind, as far as the line has them.
void ColorLine(vtkPolyData* lines, vtkIdType count, const vtkIdType* points, vtkFloatArray* colors)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    double before[3], behind[3], way[3];
    lines->GetPoint(points[std::max<vtkIdType>(i - 1, 0)], before);
    lines->GetPoint(points[std::min(i + 1, count - 1)], behind);
    vtkMath::Subtract(behind, before, way);
    const double length = vtkMath::Norm(way);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double share = length > 0.0 ? std::abs(way[axis]) / length : 1.0;
      colors->SetTypedComponent(points[i], axis, static_cast<float>(share));
    }
  }
}
}

std::string ColorByDirection(vtkPolyData* lines)
{
  vtkNew<vtkFloatArray> colors;
  colors->SetName("ColorsByDirection");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(lines->GetNumberOfPoints());
  colors->Fill(1.0);
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  vtkCellArray* cells = lines->GetLines();
  for (cells->InitTraversal(); cells->GetNextCell(count, points);)
  {
    ColorLine(lines, count, points, colors);
  }
  lines->GetPointData()->AddArray(colors);
  return colors->GetName();
}
