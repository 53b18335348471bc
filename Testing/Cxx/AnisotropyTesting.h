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
[[maybe_unused]] optics::AnisotropyFrame FrameAt(vtkImageData* covariance, vtkImageData* normals, vtkIdType point)
{
  double code[3];
  glm::dvec3 normal;
  covariance->GetPointData()->GetArray("AmbientCovariance")->GetTuple(point, code);
  normals->GetPointData()->GetArray("Normals")->GetTuple(point, &normal.x);
  return optics::EigenFrame(normal, optics::DecodeMap(normal, glm::dvec3(code[0], code[1], code[2])));
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
