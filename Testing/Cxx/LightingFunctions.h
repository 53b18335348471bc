// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lighting transfer functions in few words, for their tests.

#ifndef LightingFunctions_h
#define LightingFunctions_h

#include "vtkLightingTransferFunction.h"

#include <array>
#include <limits>
#include <vector>

namespace
{
using Function = vtkLightingTransferFunction;
using Triple = std::array<double, 3>;

const double Infinity = std::numeric_limits<double>::infinity();

inline int Add(Function* function, double a0, double a1, double b0, double b1, double softness = 0.0,
  const Triple& k = { 0.1, 0.5, 0.25 })
{
  const double a[2] = { a0, a1 };
  const double b[2] = { b0, b1 };
  const int index = function->AddBoundary(a, b, k[0], k[1], k[2]);
  if (softness > 0.0)
  {
    function->SetSoftness(index, softness);
  }
  return index;
}

inline Triple At(Function* function, double s1, double s2)
{
  Triple k;
  function->Evaluate(s1, s2, k.data());
  return k;
}

inline std::vector<float> Table(
  Function* function, double low, double high, int size, vtkPiecewiseFunction* density = nullptr)
{
  const double range[2] = { low, high };
  std::vector<float> rgba;
  function->GetTable(range, size, rgba, density);
  return rgba;
}
}

#endif
