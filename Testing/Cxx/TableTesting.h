// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A pre-integrated table with its functions, for tests.

#ifndef TableTesting_h
#define TableTesting_h

#include "Check.h"
#include "Optics.h"
#include "TransferIntegral.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPreIntegratedTable.h"

#include <algorithm>
#include <cmath>

namespace
{
struct TestTable
{
  vtkNew<vtkPreIntegratedTable> Table;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;

  explicit TestTable(int size = 256)
  {
    this->Table->SetColorFunction(this->Color);
    this->Table->SetOpacityFunction(this->Opacity);
    this->Table->SetUnitInterval(1.0);
    this->Table->SetSize(size);
    this->Opacity->AllowDuplicateScalarsOn();
    this->Color->AllowDuplicateScalarsOn();
  }

  // One colour everywhere, and a triangle of opacity.
  void AddPeak(double middle, double halfWidth, double opacity)
  {
    this->Color->AddRGBPoint(middle, 0.2, 0.4, 0.8);
    this->Opacity->AddPoint(middle - halfWidth, 0.0);
    this->Opacity->AddPoint(middle, opacity);
    this->Opacity->AddPoint(middle + halfWidth, 0.0);
  }

  // What the table says of a segment in data space.
  double Depth(double front, double back)
  {
    return this->Table->GetMean(front, back) *
      std::abs(this->Table->GetNormalizedScalar(back) - this->Table->GetNormalizedScalar(front));
  }

  // Of a path from one scalar to another in equal steps.
  double DepthOfSteps(double front, double back, int steps)
  {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      sum += this->Depth(front + (back - front) * i / steps, front + (back - front) * (i + 1) / steps);
    }
    return sum;
  }

  const float* Entry(int front, int back)
  {
    return this->Table->GetEntries() + 4 * (back * this->Table->GetSize() + front);
  }

  // Data's attenuation at an optical depth of 1.
  double Attenuation() { return 1.0 / this->Table->GetUnitInterval(); }
};

// Optical depth of AddPeak() over its width in unit intervals: the integral of -ln(1 - opacity).
inline double DepthOfPeak(double halfWidth, double opacity)
{
  const double through = 1.0 - opacity;
  const double logarithm = through > 0.0 ? through * std::log(through) : 0.0;
  return 2.0 * halfWidth * (logarithm + opacity) / opacity;
}
}

#endif
