// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RingFlow.h"

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
const vtkIdType LinesPerMiddleLine = 10;

// Turns about the ring's middle in one turn along it: whole numbers on both tori, so that bands close.
const double RingRadius = 0.62;
const double TorusRadii[2] = { 0.18, 0.33 };
const double Turns[2] = { 3.0, -2.0 };

double TurnsAt(double radius)
{
  return Turns[0] + (Turns[1] - Turns[0]) * (radius - TorusRadii[0]) / (TorusRadii[1] - TorusRadii[0]);
}

Vector FlowAt(const Vector& p)
{
  const double ring = std::max(std::hypot(p[0], p[1]), 1e-9), out = ring - RingRadius;
  const double turns = TurnsAt(std::hypot(out, p[2]));
  const double outward = -turns * p[2] / ring; // over the ring's radius here
  return { -p[1] + outward * p[0], p[0] + outward * p[1], turns * out };
}

Vector Moved(const Vector& p, const Vector& flow, double length)
{
  const double speed =
    std::max(std::sqrt(flow[0] * flow[0] + flow[1] * flow[1] + flow[2] * flow[2]), 1e-12);
  return { p[0] + flow[0] / speed * length, p[1] + flow[1] / speed * length, p[2] + flow[2] / speed * length };
}

Vector Next(const Vector& p)
{
  const Vector a = FlowAt(p), b = FlowAt(Moved(p, a, 0.5 * StepLength));
  const Vector c = FlowAt(Moved(p, b, 0.5 * StepLength)), d = FlowAt(Moved(p, c, StepLength));
  Vector mean;
  for (int i = 0; i < 3; ++i)
  {
    mean[i] = a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i];
  }
  return Moved(p, mean, StepLength);
}

// Evenly spread numbers in [0, 1), four for each line.
double Spread(vtkIdType line, int purpose)
{
  const double steps[4] = { 0.8566748838545029, 0.7338918566271260, 0.6287067210378087, 0.5385972572236101 };
  const double x = 0.5 + static_cast<double>(line + 1) * steps[purpose];
  return x - std::floor(x);
}

Vector OnTorus(double along, double radius, double around)
{
  const double ring = RingRadius + radius * std::cos(around);
  return { ring * std::cos(along), ring * std::sin(along), radius * std::sin(around) };
}

// In bands that follow the flow; the middle's lines anywhere in it.
Vector Seed(vtkIdType line, bool isInMiddle)
{
  const double along = 2.0 * Pi * Spread(line, 0);
  if (isInMiddle)
  {
    return OnTorus(along, 0.07 * std::sqrt(Spread(line, 1)), 2.0 * Pi * Spread(line, 2));
  }
  const int torus = Spread(line, 1) < 0.35 ? 0 : 1, bands = 4 + 3 * torus;
  const double band = std::floor(bands * Spread(line, 2)), width = 0.55 * 2.0 * Pi / bands;
  const double around = 2.0 * Pi * band / bands + width * (Spread(line, 3) - 0.5) + Turns[torus] * along;
  return OnTorus(along, TorusRadii[torus], around);
}

void TraceLine(vtkIdType line, bool isInMiddle, vtkPoints* points)
{
  Vector p = Seed(line, isInMiddle);
  for (vtkIdType i = 0; i < PointsOfLine; ++i)
  {
    points->SetPoint(line * PointsOfLine + i, p.data());
    p = Next(p);
  }
}
}

vtkSmartPointer<vtkPolyData> TraceRingFlow(vtkIdType segments)
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
      const bool isInMiddle = line % LinesPerMiddleLine == 0;
      types->SetValue(line, isInMiddle ? 1 : 0);
      TraceLine(line, isInMiddle, points);
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
