// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPreIntegratedTable.h"

#include "ParameterRange.h"
#include "PreIntegration.h"

#include "vtkColorTransferFunction.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPreIntegratedTable);

namespace
{
// Rows of smaller tables take less time than waking the threads does.
const int LeastSizeForThreads = 512;

// The part of the opacity function's own range that is its unit by default.
const double UnitPartOfRange = 0.01;
}

//------------------------------------------------------------------------------
vtkPreIntegratedTable::vtkPreIntegratedTable() = default;
vtkPreIntegratedTable::~vtkPreIntegratedTable() = default;

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::SetColorFunction(vtkColorTransferFunction* function)
{
  if (this->ColorFunction != function)
  {
    this->ColorFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkColorTransferFunction* vtkPreIntegratedTable::GetColorFunction()
{
  return this->ColorFunction;
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::SetOpacityFunction(vtkPiecewiseFunction* function)
{
  if (this->OpacityFunction != function)
  {
    this->OpacityFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkPreIntegratedTable::GetOpacityFunction()
{
  return this->OpacityFunction;
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::SetSize(int size)
{
  volumeoptics::SetWithinRange(this, "Size", size, 2, 4096, this->Size);
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::SetUnitInterval(double interval)
{
  volumeoptics::SetWithinRange(this, "UnitInterval", interval, 0.0, 1.0e300, this->UnitInterval);
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::SetSegmentLength(double length)
{
  volumeoptics::SetWithinRange(this, "SegmentLength", length, 0.0, 1.0e30, this->SegmentLength);
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTable::Update()
{
  if (this->BuildTime < this->GetMTime())
  {
    this->Entries.clear();
    this->Cumulative.clear();
    this->DepthsBehind.clear();
    this->LargestMean = 0.0;
    if (this->IsUsable())
    {
      this->Build();
    }
    this->BuildTime.Modified();
  }
  return !this->Entries.empty();
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTable::IsUsable()
{
  if (!this->ColorFunction || !this->OpacityFunction)
  {
    vtkErrorMacro(<< "The table has no " << (this->ColorFunction ? "opacity" : "color")
                  << " function; set both before Update().");
    return false;
  }
  if (this->ColorFunction->GetSize() == 0 || this->OpacityFunction->GetSize() == 0)
  {
    vtkErrorMacro(<< "The " << (this->ColorFunction->GetSize() > 0 ? "opacity" : "color")
                  << " function has no node; add at least one.");
    return false;
  }
  const double width = this->Range[1] - this->Range[0];
  if (!(width > 0.0) || !std::isfinite(width))
  {
    vtkErrorMacro(<< "The range [" << this->Range[0] << ", " << this->Range[1]
                  << "] is not valid; set two finite scalars, the first less than the last.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkPreIntegratedTable::EffectiveUnitInterval()
{
  if (this->UnitInterval > 0.0)
  {
    return this->UnitInterval;
  }
  const double* nodes = this->OpacityFunction->GetRange();
  const double width = nodes[1] - nodes[0];
  return UnitPartOfRange * (width > 0.0 ? width : this->Range[1] - this->Range[0]);
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::Build()
{
  volumeoptics::TransferFunctions functions;
  functions.Color = this->ColorFunction;
  functions.Opacity = this->OpacityFunction;
  std::copy(this->Range, this->Range + 2, functions.Range);
  const bool isPhysical = this->SegmentLength > 0.0;
  functions.Attenuation =
    isPhysical ? 1.0 : (this->Range[1] - this->Range[0]) / this->EffectiveUnitInterval();

  const volumeoptics::PreIntegration integration(functions, this->Size);
  this->Entries.resize(4 * static_cast<std::size_t>(this->Size) * this->Size);
  auto writeRows = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType row = begin; row < end; ++row)
    {
      isPhysical ? integration.WriteRow(static_cast<int>(row), this->SegmentLength, this->Entries.data())
                 : integration.WriteRow(static_cast<int>(row), this->Entries.data());
    }
  };
  this->Size < LeastSizeForThreads ? writeRows(0, this->Size) : vtkSMPTools::For(0, this->Size, writeRows);
  this->Cumulative = integration.Cumulative();
  this->DepthsBehind = integration.DepthsBehind();
  for (std::size_t i = 3; i < this->Entries.size(); i += 4)
  {
    this->LargestMean = std::max<double>(this->LargestMean, this->Entries[i]);
  }
}

//------------------------------------------------------------------------------
const float* vtkPreIntegratedTable::GetEntries()
{
  return this->Entries.empty() ? nullptr : this->Entries.data();
}

//------------------------------------------------------------------------------
const float* vtkPreIntegratedTable::GetCumulative()
{
  return this->Cumulative.empty() ? nullptr : this->Cumulative.data();
}

//------------------------------------------------------------------------------
const float* vtkPreIntegratedTable::GetDepthsBehind()
{
  return this->DepthsBehind.empty() ? nullptr : this->DepthsBehind.data();
}

//------------------------------------------------------------------------------
double vtkPreIntegratedTable::GetNormalizedScalar(double scalar)
{
  const double place = (scalar - this->Range[0]) / (this->Range[1] - this->Range[0]);
  return place > 0.0 ? std::min(place, 1.0) : 0.0;
}

//------------------------------------------------------------------------------
double vtkPreIntegratedTable::GetMean(double front, double back)
{
  double rgba[4];
  this->GetEntry(front, back, rgba);
  return rgba[3];
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::GetEntry(double front, double back, double rgba[4])
{
  std::fill(rgba, rgba + 4, 0.0);
  if (this->Entries.empty())
  {
    return;
  }
  const double column = this->GetNormalizedScalar(front) * (this->Size - 1);
  const double row = this->GetNormalizedScalar(back) * (this->Size - 1);
  const int firstColumn = std::min(static_cast<int>(column), this->Size - 2);
  const int firstRow = std::min(static_cast<int>(row), this->Size - 2);
  for (int corner = 0; corner < 4; ++corner)
  {
    const int right = corner % 2;
    const int up = corner / 2;
    const double weight = (right ? column - firstColumn : 1.0 - (column - firstColumn)) *
      (up ? row - firstRow : 1.0 - (row - firstRow));
    const std::size_t entry = static_cast<std::size_t>(firstRow + up) * this->Size + firstColumn + right;
    for (int i = 0; i < 4; ++i)
    {
      rgba[i] += weight * this->Entries[4 * entry + i];
    }
  }
}

//------------------------------------------------------------------------------
std::size_t vtkPreIntegratedTable::GetMemorySize()
{
  return sizeof(float) * (this->Entries.size() + this->Cumulative.size() + this->DepthsBehind.size());
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPreIntegratedTable::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->ColorFunction ? std::max(time, this->ColorFunction->GetMTime()) : time;
  return this->OpacityFunction ? std::max(time, this->OpacityFunction->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColorFunction: " << this->ColorFunction.Get() << "\n";
  os << indent << "OpacityFunction: " << this->OpacityFunction.Get() << "\n";
  os << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "UnitInterval: " << this->UnitInterval << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "LargestMean: " << this->LargestMean << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "BuildTime: " << this->BuildTime.GetMTime() << "\n";
}
