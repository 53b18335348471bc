// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The pre-integrated table: closed forms, sums of small steps, extremes of functions and settings.

#include "Check.h"
#include "Optics.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPreIntegratedTable.h"

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

namespace
{
struct Table
{
  vtkNew<vtkPreIntegratedTable> Entries;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;

  Table()
  {
    this->Color->AddRGBPoint(0.0, 0.2, 0.4, 0.8);
    this->Entries->SetColorFunction(this->Color);
    this->Entries->SetOpacityFunction(this->Opacity);
  }

  double Mean(double front, double back) { return this->Entries->GetMean(front, back); }

  double Depth(double front, double back)
  {
    const double step = std::abs(
      this->Entries->GetNormalizedScalar(back) - this->Entries->GetNormalizedScalar(front));
    return this->Mean(front, back) * step;
  }
};

}

int TestPreIntegratedTable(int, char*[])
{
  Check check;
  for (int size : {2, 64, 256, 1024, 4096}) for (int phys : {0, 1}) {
  Table t;
  t.Opacity->AddPoint(0, 0);
  t.Opacity->AddPoint(0.3, 0.0);
  t.Opacity->AddPoint(0.4, 0.5);
  t.Opacity->AddPoint(0.5, 0.0);
  t.Opacity->AddPoint(1, 0.9);
  t.Color->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  t.Entries->SetSize(size);
  t.Entries->SetSegmentLength(phys);
  if (phys && size > 1024) continue;
  std::clock_t start = std::clock();
  t.Entries->Update();
  double ms = 1e3 * (std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << size << " " << phys << ": " << ms << " ms, largest " << t.Entries->GetLargestMean() << " depth " << t.Depth(0., 1.) << " " << t.Entries->GetCumulative()[size - 1] << "\n";
  }
  return check.ExitCode();
}
