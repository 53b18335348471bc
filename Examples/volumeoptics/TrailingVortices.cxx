// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrailingVortices.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Vector = std::array<double, 3>;

const double Pi = 3.14159265358979323846;
const vtkIdType PointsOfLine = 201;
const double StepLength = 0.012;
const vtkIdType LinesPerCoreLine = 10;

// Along x; the centre line waves with growing amplitude.
struct Vortex
{
  double Y, Z, Circulation, CoreRadius, Amplitude, Frequency, Phase;

  double Wave(double x) const { return this->Amplitude * (1.3 + x); }
  Vector Center(double x) const
  {
    const double angle = this->Frequency * x + this->Phase;
    return { x, this->Y + this->Wave(x) * std::sin(angle), this->Z + this->Wave(x) * std::cos(angle) };
  }
  Vector Along(double x) const
  {
    const double angle = this->Frequency * x + this->Phase, turn = this->Wave(x) * this->Frequency;
    return { 1.0, this->Amplitude * std::sin(angle) + turn * std::cos(angle),
      this->Amplitude * std::cos(angle) - turn * std::sin(angle) };
  }
};

// A pair of strong ones, and two weak ones that these carry around.
const Vortex Vortices[] = { { 0.27, 0.0, 1.0, 0.07, 0.05, 3.5, 0.0 },
  { -0.27, 0.0, -1.0, 0.07, 0.05, 3.5, Pi }, { 0.27, 0.22, 0.35, 0.04, 0.09, 5.0, 1.0 },
  { -0.27, 0.22, -0.35, 0.04, 0.09, 5.0, Pi - 1.0 } };

// Lamb's and Oseen's vortices in a uniform stream. along: how much of the cores' own direction is added in
// the cores.
Vector FlowAt(const Vector& p, double along)
{
  Vector flow = { 1.0, 0.0, 0.0 };
  for (const Vortex& vortex : Vortices)
  {
    const Vector center = vortex.Center(p[0]);
    const double y = p[1] - center[1], z = p[2] - center[2];
    const double square = (y * y + z * z) / (vortex.CoreRadius * vortex.CoreRadius);
    const double core = std::exp(-square);
    const double swirl = 1.7 * vortex.Circulation * (square > 1e-6 ? (1.0 - core) / square : 1.0);
    const Vector way = vortex.Along(p[0]);
    flow[0] += along * core;
    flow[1] += (along + 1.0) * core * way[1] - swirl * z / vortex.CoreRadius;
    flow[2] += (along + 1.0) * core * way[2] + swirl * y / vortex.CoreRadius;
  }
  return flow;
}

Vector Moved(const Vector& p, const Vector& flow, double length)
{
  const double speed = std::max(std::sqrt(flow[0] * flow[0] + flow[1] * flow[1] + flow[2] * flow[2]), 1e-12);
  return { p[0] + flow[0] / speed * length, p[1] + flow[1] / speed * length,
    p[2] + flow[2] / speed * length };
}

Vector Next(const Vector& p, double along)
{
  const Vector a = FlowAt(p, along), b = FlowAt(Moved(p, a, 0.5 * StepLength), along);
  const Vector c = FlowAt(Moved(p, b, 0.5 * StepLength), along), d = FlowAt(Moved(p, c, StepLength), along);
  Vector mean;
  for (int i = 0; i < 3; ++i)
  {
    mean[i] = a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i];
  }
  return Moved(p, mean, StepLength);
}

// Evenly spread numbers in [0, 1), three for each line.
double Spread(vtkIdType line, int purpose)
{
  const double steps[3] = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };
  const double x = 0.5 + static_cast<double>(line + 1) * steps[purpose];
  return x - std::floor(x);
}

// On shells around a vortex.
Vector Seed(vtkIdType line, bool isCoreLine)
{
  const double shells[4] = { 0.7, 1.2, 1.9, 3.0 };
  const Vortex& vortex = Vortices[line / LinesPerCoreLine % 4];
  const double x = -1.0 + 0.2 * Spread(line, 0);
  const Vector center = vortex.Center(x);
  const double shell = shells[static_cast<int>(4.0 * Spread(line, 1))];
  const double radius = vortex.CoreRadius * (isCoreLine ? 0.4 * std::sqrt(Spread(line, 1)) : shell);
  const double angle = 2.0 * Pi * Spread(line, 2);
  return { x, center[1] + radius * std::cos(angle), center[2] + radius * std::sin(angle) };
}

void TraceLine(vtkIdType line, bool isCoreLine, vtkPoints* points)
{
  Vector p = Seed(line, isCoreLine);
  for (vtkIdType i = 0; i < PointsOfLine; ++i)
  {
    points->SetPoint(line * PointsOfLine + i, p.data());
    p = Next(p, isCoreLine ? 12.0 : 0.0);
  }
}
}

vtkSmartPointer<vtkPolyData> TraceTrailingVortices(vtkIdType segments)
{
  const vtkIdType lines = std::max<vtkIdType>(segments / (PointsOfLine - 1), 1);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(lines * PointsOfLine);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName("LineType");
  types->SetNumberOfValues(lines);
  vtkSMPTools::For(0, lines, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType line = first; line < last; ++line)
    {
      const bool isCoreLine = line % LinesPerCoreLine == 0;
      types->SetValue(line, isCoreLine ? 1 : 0);
      TraceLine(line, isCoreLine, points);
    }
  });
  vtkNew<vtkCellArray> cells;
  for (vtkIdType line = 0; line < lines; ++line)
  {
    cells->InsertNextCell(static_cast<int>(PointsOfLine));
    for (vtkIdType i = 0; i < PointsOfLine; ++i)
    {
      cells->InsertCellPoint(line * PointsOfLine + i);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetCellData()->AddArray(types);
  return data;
}
