// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Normals that an image brings along.

#ifndef NormalSource_h
#define NormalSource_h

#include "ScalarSource.h"

namespace volumeoptics
{
class NormalSource
{
public:
  // normals: a point array of three components of the image.
  NormalSource(vtkImageData* image, vtkDataArray* normals)
    : Rows{ ImageRows(image, normals, 0), ImageRows(image, normals, 1), ImageRows(image, normals, 2) }
  {
  }

  const Extent& GetBox() const { return this->Rows[0].GetBox(); }

  // Made unit; 0 where one is 0 or has no value.
  void Read(int x0, int x1, int y, int z, glm::dvec3* normals) const
  {
    const std::size_t count = x1 - x0 + 1;
    std::vector<double> numbers(3 * count);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Rows[axis].Read(x0, x1, y, z, numbers.data() + axis * count);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const glm::dvec3 normal(numbers[i], numbers[i + count], numbers[i + 2 * count]);
      const double length = glm::length(normal);
      normals[i] = length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3(0.0);
    }
  }

private:
  ImageRows Rows[3];
};
}

#endif
