// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Decoded anisotropies of a filter's output, for tests.

#ifndef AnisotropyTesting_h
#define AnisotropyTesting_h

#include "Optics.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
namespace testing
{
[[maybe_unused]] optics::AnisotropyFrame FrameAt(
  vtkImageData* covariance, vtkImageData* normals, vtkIdType point)
{
  double code[3];
  glm::dvec3 normal;
  covariance->GetPointData()->GetArray("AmbientCovariance")->GetTuple(point, code);
  normals->GetPointData()->GetArray("Normals")->GetTuple(point, &normal.x);
  return optics::EigenFrame(normal, optics::DecodeMap(normal, glm::dvec3(code[0], code[1], code[2])));
}

// How a storage is decoded: [Ament2015]'s for 0 = Map, 1 = Components, 2 = World.
[[maybe_unused]] glm::dvec2 Decoded(int storage, const glm::dvec3& normal, const double* code)
{
  if (storage == 2)
  {
    optics::WorldTensor tensor;
    tensor.diagonal = glm::dvec3(code[0], code[1], code[2]);
    tensor.mixed = glm::dvec2(code[3], code[4]);
    return optics::DecodeWorld(normal, tensor);
  }
  const glm::dvec3 numbers(code[0], code[1], code[2]);
  return storage == 0 ? optics::DecodeMap(normal, numbers) : optics::DecodeComponents(numbers);
}

// As a renderer decodes: normal and code interpolated linearly at a place in voxels from the extent's
// first voxel.
[[maybe_unused]] optics::AnisotropyFrame FrameBetween(
  vtkImageData* covariance, vtkImageData* normals, int storage, const glm::dvec3& place)
{
  vtkDataArray* codes = covariance->GetPointData()->GetArray("AmbientCovariance");
  vtkDataArray* directions = normals->GetPointData()->GetArray("Normals");
  const glm::ivec3 corner(glm::floor(place));
  const glm::dvec3 fraction = place - glm::dvec3(corner);
  double code[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  glm::dvec3 normal(0.0);
  int size[3];
  covariance->GetDimensions(size);
  for (int i = 0; i < 8; ++i)
  {
    double weight = 1.0;
    vtkIdType point = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int isNext = i >> axis & 1;
      weight *= isNext ? fraction[axis] : 1.0 - fraction[axis];
      point = point * size[axis] + corner[axis] + isNext;
    }
    for (int c = 0; c < codes->GetNumberOfComponents(); ++c)
    {
      code[c] += weight * codes->GetComponent(point, c);
    }
    normal += weight *
      glm::dvec3(directions->GetComponent(point, 0), directions->GetComponent(point, 1),
        directions->GetComponent(point, 2));
  }
  normal = glm::normalize(normal);
  return optics::EigenFrame(normal, Decoded(storage, normal, code));
}

// Between two lines, degrees in [0, 90].
[[maybe_unused]] double LineAngle(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::degrees(std::acos(std::min(std::abs(glm::dot(a, b)), 1.0)));
}

// (l2 - l1)/(l2 + l1).
[[maybe_unused]] double Strength(const optics::AnisotropyFrame& frame)
{
  return std::tanh(frame.logRatio / 2.0);
}
}
}

#endif
